model slider_crank
  parameter Real r = 0.04775 "m";
  parameter Real l = 0.144 "m";
  parameter Real m = 0.98496667 "kg";
  parameter Real J = 0.05 "kg m2";
  Real motor_effort "N m";
  Real motor_flow "rad/s";
  Real crank_effort "N m";
  Real crank_flow "rad/s";
  Real rub_effort "N m";
  Real rub_flow "rad/s";
  Real slider_1_effort "N m";
  Real slider_1_flow "rad/s";
  Real slider_2_effort "N";
  Real slider_2_flow "m/s";
  Real piston_effort "N";
  Real piston_flow "m/s";
  Real theta(start = 0.3, fixed = true) "1";
  Real crank_momentum(start = 5.0, fixed = true) "N m s";
  Real piston_momentum "N s";
equation
  der(theta) = motor_flow;
  // Se : motor
  motor_effort = 5.0;
  // 1 : shaft
  crank_flow = motor_flow;
  rub_flow = motor_flow;
  slider_1_flow = motor_flow;
  0 = + motor_effort - crank_effort - rub_effort - slider_1_effort;
  // I : crank
  der(crank_momentum) = crank_effort;
  crank_flow = crank_momentum/J;
  // R : rub
  rub_effort = 0.02*rub_flow;
  // MTF : slider
  slider_2_flow = (-r*sin(theta) - r^2.0*sin(theta)*cos(theta)/sqrt(l^2.0 - r^2.0*sin(theta)^2.0))*slider_1_flow;
  slider_1_effort = (-r*sin(theta) - r^2.0*sin(theta)*cos(theta)/sqrt(l^2.0 - r^2.0*sin(theta)^2.0))*slider_2_effort;
  // 1 : guide
  piston_flow = slider_2_flow;
  0 = + slider_2_effort - piston_effort;
  // I : piston
  der(piston_momentum) = piston_effort;
  piston_flow = piston_momentum/m;
end slider_crank;
