model mass_spring_damper
  parameter Real m = 1.2 "kg";
  parameter Real k = 250.0 "N/m";
  parameter Real c = 3.0 "kg/s";
  parameter Real F = 10.0 "N";
  Real push_effort "N";
  Real push_flow "m/s";
  Real mass_effort "N";
  Real mass_flow "m/s";
  Real spring_effort "N";
  Real spring_flow "m/s";
  Real damper_effort "N";
  Real damper_flow "m/s";
  Real mass_momentum(start = 0.0, fixed = true) "N s";
  Real spring_displacement(start = 0.0, fixed = true) "m";
equation
  // Se : push
  push_effort = F;
  // 1 : car
  mass_flow = push_flow;
  spring_flow = push_flow;
  damper_flow = push_flow;
  0 = + push_effort - mass_effort - spring_effort - damper_effort;
  // I : mass
  der(mass_momentum) = mass_effort;
  mass_flow = mass_momentum/m;
  // C : spring
  der(spring_displacement) = spring_flow;
  spring_effort = k*spring_displacement;
  // R : damper
  damper_effort = c*damper_flow;
end mass_spring_damper;
