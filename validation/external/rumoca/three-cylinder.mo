model Three_cylinder_engine_with_balancer_shaft
  parameter Real r = 0.07 "m";
  parameter Real l = 0.2 "m";
  parameter Real piston_mass = 1.5 "kg";
  parameter Real rod_mass = 1.5 "kg";
  parameter Real rod_inertia = 0.013333333333333336 "kg m2";
  parameter Real area = 0.007000448687645795 "m2";
  parameter Real g = 9.80665 "m/s2";
  Real crankshaft_effort "N m";
  Real crankshaft_flow "rad/s";
  Real crankshaft_unbalance1_motion_1_effort "N m";
  Real crankshaft_unbalance1_motion_1_flow "rad/s";
  Real crankshaft_unbalance1_motion_2_effort "N";
  Real crankshaft_unbalance1_motion_2_flow "m/s";
  Real crankshaft_unbalance1_weight_x_effort "N";
  Real crankshaft_unbalance1_weight_x_flow "m/s";
  Real crankshaft_unbalance2_motion_1_effort "N m";
  Real crankshaft_unbalance2_motion_1_flow "rad/s";
  Real crankshaft_unbalance2_motion_2_effort "N";
  Real crankshaft_unbalance2_motion_2_flow "m/s";
  Real crankshaft_unbalance2_weight_x_effort "N";
  Real crankshaft_unbalance2_weight_x_flow "m/s";
  Real shaft1_unbalance1_motion_1_effort "N m";
  Real shaft1_unbalance1_motion_1_flow "rad/s";
  Real shaft1_unbalance1_motion_2_effort "N";
  Real shaft1_unbalance1_motion_2_flow "m/s";
  Real shaft1_unbalance1_weight_x_effort "N";
  Real shaft1_unbalance1_weight_x_flow "m/s";
  Real shaft1_unbalance2_motion_1_effort "N m";
  Real shaft1_unbalance2_motion_1_flow "rad/s";
  Real shaft1_unbalance2_motion_2_effort "N";
  Real shaft1_unbalance2_motion_2_flow "m/s";
  Real shaft1_unbalance2_weight_x_effort "N";
  Real shaft1_unbalance2_weight_x_flow "m/s";
  Real piston1_motion_1_effort "N m";
  Real piston1_motion_1_flow "rad/s";
  Real piston1_motion_2_effort "N";
  Real piston1_motion_2_flow "m/s";
  Real piston1_x_effort "N";
  Real piston1_x_flow "m/s";
  Real piston1_weight_x_effort "N";
  Real piston1_weight_x_flow "m/s";
  Real piston1_y_effort "N";
  Real piston1_y_flow "m/s";
  Real rod1_motion_1_effort "N m";
  Real rod1_motion_1_flow "rad/s";
  Real rod1_motion_2_effort "N";
  Real rod1_motion_2_flow "m/s";
  Real rod1_x_effort "N";
  Real rod1_x_flow "m/s";
  Real rod1_weight_x_effort "N";
  Real rod1_weight_x_flow "m/s";
  Real rod1_y_effort "N";
  Real rod1_y_flow "m/s";
  Real rod_turn1_motion_1_effort "N m";
  Real rod_turn1_motion_1_flow "rad/s";
  Real rod_turn1_effort "N m";
  Real rod_turn1_flow "rad/s";
  Real piston2_motion_1_effort "N m";
  Real piston2_motion_1_flow "rad/s";
  Real piston2_motion_2_effort "N";
  Real piston2_motion_2_flow "m/s";
  Real piston2_x_effort "N";
  Real piston2_x_flow "m/s";
  Real piston2_weight_x_effort "N";
  Real piston2_weight_x_flow "m/s";
  Real piston2_y_effort "N";
  Real piston2_y_flow "m/s";
  Real rod2_motion_1_effort "N m";
  Real rod2_motion_1_flow "rad/s";
  Real rod2_motion_2_effort "N";
  Real rod2_motion_2_flow "m/s";
  Real rod2_x_effort "N";
  Real rod2_x_flow "m/s";
  Real rod2_weight_x_effort "N";
  Real rod2_weight_x_flow "m/s";
  Real rod2_y_effort "N";
  Real rod2_y_flow "m/s";
  Real rod_turn2_motion_1_effort "N m";
  Real rod_turn2_motion_1_flow "rad/s";
  Real rod_turn2_effort "N m";
  Real rod_turn2_flow "rad/s";
  Real piston3_motion_1_effort "N m";
  Real piston3_motion_1_flow "rad/s";
  Real piston3_motion_2_effort "N";
  Real piston3_motion_2_flow "m/s";
  Real piston3_x_effort "N";
  Real piston3_x_flow "m/s";
  Real piston3_weight_x_effort "N";
  Real piston3_weight_x_flow "m/s";
  Real piston3_y_effort "N";
  Real piston3_y_flow "m/s";
  Real rod3_motion_1_effort "N m";
  Real rod3_motion_1_flow "rad/s";
  Real rod3_motion_2_effort "N";
  Real rod3_motion_2_flow "m/s";
  Real rod3_x_effort "N";
  Real rod3_x_flow "m/s";
  Real rod3_weight_x_effort "N";
  Real rod3_weight_x_flow "m/s";
  Real rod3_y_effort "N";
  Real rod3_y_flow "m/s";
  Real rod_turn3_motion_1_effort "N m";
  Real rod_turn3_motion_1_flow "rad/s";
  Real rod_turn3_effort "N m";
  Real rod_turn3_flow "rad/s";
  Real theta(start = 0.0, fixed = true) "1";
  Real crankshaft_unbalance1_x "m";
  Real crankshaft_unbalance1_y "m";
  Real crankshaft_unbalance2_x "m";
  Real crankshaft_unbalance2_y "m";
  Real shaft1_unbalance1_x "m";
  Real shaft1_unbalance1_y "m";
  Real shaft1_unbalance2_x "m";
  Real shaft1_unbalance2_y "m";
  Real phi1 "1";
  Real px1 "m";
  Real py1 "m";
  Real px_rate1 "m";
  Real py_rate1 "m";
  Real across1 "m";
  Real along1 "m";
  Real s1 "m";
  Real dx1 "m";
  Real dy1 "m";
  Real s_rate1 "m";
  Real dx_rate1 "m";
  Real dy_rate1 "m";
  Real rod_x1 "m";
  Real rod_x_rate1 "m";
  Real rod_y1 "m";
  Real rod_y_rate1 "m";
  Real phi2 "1";
  Real px2 "m";
  Real py2 "m";
  Real px_rate2 "m";
  Real py_rate2 "m";
  Real across2 "m";
  Real along2 "m";
  Real s2 "m";
  Real dx2 "m";
  Real dy2 "m";
  Real s_rate2 "m";
  Real dx_rate2 "m";
  Real dy_rate2 "m";
  Real rod_x2 "m";
  Real rod_x_rate2 "m";
  Real rod_y2 "m";
  Real rod_y_rate2 "m";
  Real phi3 "1";
  Real px3 "m";
  Real py3 "m";
  Real px_rate3 "m";
  Real py_rate3 "m";
  Real across3 "m";
  Real along3 "m";
  Real s3 "m";
  Real dx3 "m";
  Real dy3 "m";
  Real s_rate3 "m";
  Real dx_rate3 "m";
  Real dy_rate3 "m";
  Real rod_x3 "m";
  Real rod_x_rate3 "m";
  Real rod_y3 "m";
  Real rod_y_rate3 "m";
  Real crankshaft_momentum(start = 630.2034863101125, fixed = true) "N m s";
  Real piston1_x_momentum "N s";
  Real piston1_y_momentum "N s";
  Real rod1_x_momentum "N s";
  Real rod1_y_momentum "N s";
  Real rod_turn1_momentum "N m s";
  Real piston2_x_momentum "N s";
  Real piston2_y_momentum "N s";
  Real rod2_x_momentum "N s";
  Real rod2_y_momentum "N s";
  Real rod_turn2_momentum "N m s";
  Real piston3_x_momentum "N s";
  Real piston3_y_momentum "N s";
  Real rod3_x_momentum "N s";
  Real rod3_y_momentum "N s";
  Real rod_turn3_momentum "N m s";
equation
  der(theta) = crankshaft_flow;
  crankshaft_unbalance1_x = 0.05*cos(theta + 2.6179938779914944);
  crankshaft_unbalance1_y = 0.05*sin(theta + 2.6179938779914944);
  crankshaft_unbalance2_x = 0.05*cos(theta - 0.5235987755982987);
  crankshaft_unbalance2_y = 0.05*sin(theta - 0.5235987755982987);
  shaft1_unbalance1_x = 0.05*cos(-theta - 2.617993877991494);
  shaft1_unbalance1_y = 0.05*sin(-theta - 2.617993877991494);
  shaft1_unbalance2_x = 0.05*cos(-theta + 0.5235987755982989);
  shaft1_unbalance2_y = 0.05*sin(-theta + 0.5235987755982989);
  phi1 = theta;
  px1 = r*cos(phi1);
  py1 = r*sin(phi1);
  px_rate1 = -py1;
  py_rate1 = px1;
  across1 = -py1;
  along1 = sqrt(l^2.0 - across1^2.0);
  s1 = px1 + along1;
  dx1 = along1;
  dy1 = across1;
  s_rate1 = (dx1*px_rate1 + dy1*py_rate1)/along1;
  dx_rate1 = s_rate1 - px_rate1;
  dy_rate1 = -py_rate1;
  rod_x1 = px1 + 0.3333333333333333*dx1;
  rod_x_rate1 = px_rate1 + 0.3333333333333333*dx_rate1;
  rod_y1 = py1 + 0.3333333333333333*dy1;
  rod_y_rate1 = py_rate1 + 0.3333333333333333*dy_rate1;
  phi2 = theta + 4.1887902047863905;
  px2 = r*cos(phi2);
  py2 = r*sin(phi2);
  px_rate2 = -py2;
  py_rate2 = px2;
  across2 = -py2;
  along2 = sqrt(l^2.0 - across2^2.0);
  s2 = px2 + along2;
  dx2 = along2;
  dy2 = across2;
  s_rate2 = (dx2*px_rate2 + dy2*py_rate2)/along2;
  dx_rate2 = s_rate2 - px_rate2;
  dy_rate2 = -py_rate2;
  rod_x2 = px2 + 0.3333333333333333*dx2;
  rod_x_rate2 = px_rate2 + 0.3333333333333333*dx_rate2;
  rod_y2 = py2 + 0.3333333333333333*dy2;
  rod_y_rate2 = py_rate2 + 0.3333333333333333*dy_rate2;
  phi3 = theta + 2.0943951023931953;
  px3 = r*cos(phi3);
  py3 = r*sin(phi3);
  px_rate3 = -py3;
  py_rate3 = px3;
  across3 = -py3;
  along3 = sqrt(l^2.0 - across3^2.0);
  s3 = px3 + along3;
  dx3 = along3;
  dy3 = across3;
  s_rate3 = (dx3*px_rate3 + dy3*py_rate3)/along3;
  dx_rate3 = s_rate3 - px_rate3;
  dy_rate3 = -py_rate3;
  rod_x3 = px3 + 0.3333333333333333*dx3;
  rod_x_rate3 = px_rate3 + 0.3333333333333333*dx_rate3;
  rod_y3 = py3 + 0.3333333333333333*dy3;
  rod_y_rate3 = py_rate3 + 0.3333333333333333*dy_rate3;
  // 1 : crank
  crankshaft_unbalance1_motion_1_flow = crankshaft_flow;
  crankshaft_unbalance2_motion_1_flow = crankshaft_flow;
  shaft1_unbalance1_motion_1_flow = crankshaft_flow;
  shaft1_unbalance2_motion_1_flow = crankshaft_flow;
  piston1_motion_1_flow = crankshaft_flow;
  rod1_motion_1_flow = crankshaft_flow;
  rod_turn1_motion_1_flow = crankshaft_flow;
  piston2_motion_1_flow = crankshaft_flow;
  rod2_motion_1_flow = crankshaft_flow;
  rod_turn2_motion_1_flow = crankshaft_flow;
  piston3_motion_1_flow = crankshaft_flow;
  rod3_motion_1_flow = crankshaft_flow;
  rod_turn3_motion_1_flow = crankshaft_flow;
  0 = - crankshaft_effort - crankshaft_unbalance1_motion_1_effort - crankshaft_unbalance2_motion_1_effort - shaft1_unbalance1_motion_1_effort - shaft1_unbalance2_motion_1_effort - piston1_motion_1_effort - rod1_motion_1_effort - rod_turn1_motion_1_effort - piston2_motion_1_effort - rod2_motion_1_effort - rod_turn2_motion_1_effort - piston3_motion_1_effort - rod3_motion_1_effort - rod_turn3_motion_1_effort;
  // I : crankshaft
  der(crankshaft_momentum) = crankshaft_effort;
  crankshaft_flow = crankshaft_momentum/3.009;
  // MTF : crankshaft_unbalance1_motion
  crankshaft_unbalance1_motion_2_flow = (-crankshaft_unbalance1_y)*crankshaft_unbalance1_motion_1_flow;
  crankshaft_unbalance1_motion_1_effort = (-crankshaft_unbalance1_y)*crankshaft_unbalance1_motion_2_effort;
  // 1 : crankshaft_unbalance1_vx
  crankshaft_unbalance1_weight_x_flow = crankshaft_unbalance1_motion_2_flow;
  0 = + crankshaft_unbalance1_motion_2_effort + crankshaft_unbalance1_weight_x_effort;
  // Se : crankshaft_unbalance1_weight_x
  crankshaft_unbalance1_weight_x_effort = -2.4248711305964283*g;
  // MTF : crankshaft_unbalance2_motion
  crankshaft_unbalance2_motion_2_flow = (-crankshaft_unbalance2_y)*crankshaft_unbalance2_motion_1_flow;
  crankshaft_unbalance2_motion_1_effort = (-crankshaft_unbalance2_y)*crankshaft_unbalance2_motion_2_effort;
  // 1 : crankshaft_unbalance2_vx
  crankshaft_unbalance2_weight_x_flow = crankshaft_unbalance2_motion_2_flow;
  0 = + crankshaft_unbalance2_motion_2_effort + crankshaft_unbalance2_weight_x_effort;
  // Se : crankshaft_unbalance2_weight_x
  crankshaft_unbalance2_weight_x_effort = -2.424871130596429*g;
  // MTF : shaft1_unbalance1_motion
  shaft1_unbalance1_motion_2_flow = (shaft1_unbalance1_y)*shaft1_unbalance1_motion_1_flow;
  shaft1_unbalance1_motion_1_effort = (shaft1_unbalance1_y)*shaft1_unbalance1_motion_2_effort;
  // 1 : shaft1_unbalance1_vx
  shaft1_unbalance1_weight_x_flow = shaft1_unbalance1_motion_2_flow;
  0 = + shaft1_unbalance1_motion_2_effort + shaft1_unbalance1_weight_x_effort;
  // Se : shaft1_unbalance1_weight_x
  shaft1_unbalance1_weight_x_effort = -0.6062179999999999*g;
  // MTF : shaft1_unbalance2_motion
  shaft1_unbalance2_motion_2_flow = (shaft1_unbalance2_y)*shaft1_unbalance2_motion_1_flow;
  shaft1_unbalance2_motion_1_effort = (shaft1_unbalance2_y)*shaft1_unbalance2_motion_2_effort;
  // 1 : shaft1_unbalance2_vx
  shaft1_unbalance2_weight_x_flow = shaft1_unbalance2_motion_2_flow;
  0 = + shaft1_unbalance2_motion_2_effort + shaft1_unbalance2_weight_x_effort;
  // Se : shaft1_unbalance2_weight_x
  shaft1_unbalance2_weight_x_effort = -0.606218*g;
  // MTF : piston1_motion
  piston1_motion_2_flow = (s_rate1)*piston1_motion_1_flow;
  piston1_y_flow = (0.0)*piston1_motion_1_flow;
  piston1_motion_1_effort = (s_rate1)*piston1_motion_2_effort + (0.0)*piston1_y_effort;
  // I : piston1_x
  der(piston1_x_momentum) = piston1_x_effort;
  piston1_x_flow = piston1_x_momentum/piston_mass;
  // 1 : piston1_vx
  piston1_x_flow = piston1_motion_2_flow;
  piston1_weight_x_flow = piston1_motion_2_flow;
  0 = + piston1_motion_2_effort - piston1_x_effort + piston1_weight_x_effort;
  // Se : piston1_weight_x
  piston1_weight_x_effort = -piston_mass*g;
  // I : piston1_y
  der(piston1_y_momentum) = piston1_y_effort;
  piston1_y_flow = piston1_y_momentum/piston_mass;
  // MTF : rod1_motion
  rod1_motion_2_flow = (rod_x_rate1)*rod1_motion_1_flow;
  rod1_y_flow = (rod_y_rate1)*rod1_motion_1_flow;
  rod1_motion_1_effort = (rod_x_rate1)*rod1_motion_2_effort + (rod_y_rate1)*rod1_y_effort;
  // I : rod1_x
  der(rod1_x_momentum) = rod1_x_effort;
  rod1_x_flow = rod1_x_momentum/rod_mass;
  // 1 : rod1_vx
  rod1_x_flow = rod1_motion_2_flow;
  rod1_weight_x_flow = rod1_motion_2_flow;
  0 = + rod1_motion_2_effort - rod1_x_effort + rod1_weight_x_effort;
  // Se : rod1_weight_x
  rod1_weight_x_effort = -rod_mass*g;
  // I : rod1_y
  der(rod1_y_momentum) = rod1_y_effort;
  rod1_y_flow = rod1_y_momentum/rod_mass;
  // MTF : rod_turn1_motion
  rod_turn1_flow = ((dx1*dy_rate1 - dy1*dx_rate1)/l^2.0)*rod_turn1_motion_1_flow;
  rod_turn1_motion_1_effort = ((dx1*dy_rate1 - dy1*dx_rate1)/l^2.0)*rod_turn1_effort;
  // I : rod_turn1
  der(rod_turn1_momentum) = rod_turn1_effort;
  rod_turn1_flow = rod_turn1_momentum/rod_inertia;
  // MTF : piston2_motion
  piston2_motion_2_flow = (s_rate2)*piston2_motion_1_flow;
  piston2_y_flow = (0.0)*piston2_motion_1_flow;
  piston2_motion_1_effort = (s_rate2)*piston2_motion_2_effort + (0.0)*piston2_y_effort;
  // I : piston2_x
  der(piston2_x_momentum) = piston2_x_effort;
  piston2_x_flow = piston2_x_momentum/piston_mass;
  // 1 : piston2_vx
  piston2_x_flow = piston2_motion_2_flow;
  piston2_weight_x_flow = piston2_motion_2_flow;
  0 = + piston2_motion_2_effort - piston2_x_effort + piston2_weight_x_effort;
  // Se : piston2_weight_x
  piston2_weight_x_effort = -piston_mass*g;
  // I : piston2_y
  der(piston2_y_momentum) = piston2_y_effort;
  piston2_y_flow = piston2_y_momentum/piston_mass;
  // MTF : rod2_motion
  rod2_motion_2_flow = (rod_x_rate2)*rod2_motion_1_flow;
  rod2_y_flow = (rod_y_rate2)*rod2_motion_1_flow;
  rod2_motion_1_effort = (rod_x_rate2)*rod2_motion_2_effort + (rod_y_rate2)*rod2_y_effort;
  // I : rod2_x
  der(rod2_x_momentum) = rod2_x_effort;
  rod2_x_flow = rod2_x_momentum/rod_mass;
  // 1 : rod2_vx
  rod2_x_flow = rod2_motion_2_flow;
  rod2_weight_x_flow = rod2_motion_2_flow;
  0 = + rod2_motion_2_effort - rod2_x_effort + rod2_weight_x_effort;
  // Se : rod2_weight_x
  rod2_weight_x_effort = -rod_mass*g;
  // I : rod2_y
  der(rod2_y_momentum) = rod2_y_effort;
  rod2_y_flow = rod2_y_momentum/rod_mass;
  // MTF : rod_turn2_motion
  rod_turn2_flow = ((dx2*dy_rate2 - dy2*dx_rate2)/l^2.0)*rod_turn2_motion_1_flow;
  rod_turn2_motion_1_effort = ((dx2*dy_rate2 - dy2*dx_rate2)/l^2.0)*rod_turn2_effort;
  // I : rod_turn2
  der(rod_turn2_momentum) = rod_turn2_effort;
  rod_turn2_flow = rod_turn2_momentum/rod_inertia;
  // MTF : piston3_motion
  piston3_motion_2_flow = (s_rate3)*piston3_motion_1_flow;
  piston3_y_flow = (0.0)*piston3_motion_1_flow;
  piston3_motion_1_effort = (s_rate3)*piston3_motion_2_effort + (0.0)*piston3_y_effort;
  // I : piston3_x
  der(piston3_x_momentum) = piston3_x_effort;
  piston3_x_flow = piston3_x_momentum/piston_mass;
  // 1 : piston3_vx
  piston3_x_flow = piston3_motion_2_flow;
  piston3_weight_x_flow = piston3_motion_2_flow;
  0 = + piston3_motion_2_effort - piston3_x_effort + piston3_weight_x_effort;
  // Se : piston3_weight_x
  piston3_weight_x_effort = -piston_mass*g;
  // I : piston3_y
  der(piston3_y_momentum) = piston3_y_effort;
  piston3_y_flow = piston3_y_momentum/piston_mass;
  // MTF : rod3_motion
  rod3_motion_2_flow = (rod_x_rate3)*rod3_motion_1_flow;
  rod3_y_flow = (rod_y_rate3)*rod3_motion_1_flow;
  rod3_motion_1_effort = (rod_x_rate3)*rod3_motion_2_effort + (rod_y_rate3)*rod3_y_effort;
  // I : rod3_x
  der(rod3_x_momentum) = rod3_x_effort;
  rod3_x_flow = rod3_x_momentum/rod_mass;
  // 1 : rod3_vx
  rod3_x_flow = rod3_motion_2_flow;
  rod3_weight_x_flow = rod3_motion_2_flow;
  0 = + rod3_motion_2_effort - rod3_x_effort + rod3_weight_x_effort;
  // Se : rod3_weight_x
  rod3_weight_x_effort = -rod_mass*g;
  // I : rod3_y
  der(rod3_y_momentum) = rod3_y_effort;
  rod3_y_flow = rod3_y_momentum/rod_mass;
  // MTF : rod_turn3_motion
  rod_turn3_flow = ((dx3*dy_rate3 - dy3*dx_rate3)/l^2.0)*rod_turn3_motion_1_flow;
  rod_turn3_motion_1_effort = ((dx3*dy_rate3 - dy3*dx_rate3)/l^2.0)*rod_turn3_effort;
  // I : rod_turn3
  der(rod_turn3_momentum) = rod_turn3_effort;
  rod_turn3_flow = rod_turn3_momentum/rod_inertia;
end Three_cylinder_engine_with_balancer_shaft;
