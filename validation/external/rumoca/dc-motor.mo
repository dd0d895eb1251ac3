model dc_motor
  parameter Real U = 24.0 "V";
  parameter Real L = 0.002 "H";
  parameter Real Ra = 0.5 "Ohm";
  parameter Real K = 0.08 "Wb";
  parameter Real J = 0.0003 "kg m2";
  parameter Real b = 0.0002 "J s";
  parameter Real load = -0.3 "N m";
  Real battery_effort "V";
  Real battery_flow "A";
  Real coil_effort "V";
  Real coil_flow "A";
  Real copper_effort "V";
  Real copper_flow "A";
  Real armature_1_effort "V";
  Real armature_1_flow "A";
  Real armature_2_effort "N m";
  Real armature_2_flow "rad/s";
  Real flywheel_effort "N m";
  Real flywheel_flow "rad/s";
  Real bearing_effort "N m";
  Real bearing_flow "rad/s";
  Real brake_effort "N m";
  Real brake_flow "rad/s";
  Real coil_momentum(start = 0.0, fixed = true) "V s";
  Real flywheel_momentum(start = 0.0, fixed = true) "N m s";
equation
  // Se : battery
  battery_effort = U;
  // 1 : circuit
  coil_flow = battery_flow;
  copper_flow = battery_flow;
  armature_1_flow = battery_flow;
  0 = + battery_effort - coil_effort - copper_effort - armature_1_effort;
  // I : coil
  der(coil_momentum) = coil_effort;
  coil_flow = coil_momentum/L;
  // R : copper
  copper_effort = Ra*copper_flow;
  // GY : armature
  armature_1_effort = (K)*armature_2_flow;
  armature_2_effort = (K)*armature_1_flow;
  // 1 : shaft
  flywheel_flow = armature_2_flow;
  bearing_flow = armature_2_flow;
  brake_flow = armature_2_flow;
  0 = + armature_2_effort - flywheel_effort - bearing_effort + brake_effort;
  // I : flywheel
  der(flywheel_momentum) = flywheel_effort;
  flywheel_flow = flywheel_momentum/J;
  // R : bearing
  bearing_effort = b*bearing_flow;
  // Se : brake
  brake_effort = load;
end dc_motor;
