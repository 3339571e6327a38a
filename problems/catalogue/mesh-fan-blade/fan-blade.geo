// A leaned and twisted fan blade with a cambered section, of hexahedra of 27 nodes. Lengths in metres.
// gmsh -3 -order 2 -format msh41 fan-blade.geo -o fan-blade.msh

height = 0.20; lean = 0.05; twist = 20 * Pi / 180;
chord_root = 0.080; chord_tip = 0.060; thick_root = 0.008; thick_tip = 0.004; camber = 0.06;  // camber: of the chord
along = 57; across = 11; through = 2;  // nodes of elements along height, chord and thickness

// Section k at a third of the height each: corners and middles of its pressure and its suction side.
For k In {0:3}
  s = k / 3;
  c = chord_root + s * (chord_tip - chord_root);
  t = thick_root + s * (thick_tip - thick_root);
  a = twist * s;
  For side In {0:1}
    For i In {0:2}
      x = (i - 1) * 0.5 * c;
      h = (i == 1) ? camber * c : 0;
      w = (i == 1) ? 0.5 * t : 0.2 * t;
      y = h + (2 * side - 1) * w;
      Point(100 * k + 10 * side + i) = {x * Cos(a) - y * Sin(a), lean * s * s + x * Sin(a) + y * Cos(a), height * s};
    EndFor
  EndFor
EndFor

For k In {0:3:3}
  For side In {0:1}
    p = 100 * k + 10 * side;
    Spline(p + 1) = {p, p + 1, p + 2};
  EndFor
  Line(100 * k + 21) = {100 * k, 100 * k + 10};
  Line(100 * k + 22) = {100 * k + 2, 100 * k + 12};
  Curve Loop(100 * k + 1) = {100 * k + 1, 100 * k + 22, -(100 * k + 11), -(100 * k + 21)};
  Surface(100 * k + 1) = {100 * k + 1};
  Transfinite Curve {100 * k + 1, 100 * k + 11} = across;
  Transfinite Curve {100 * k + 21, 100 * k + 22} = through;
EndFor
For side In {0:1}
  For i In {0:2:2}
    p = 10 * side + i;
    Spline(1000 + p) = {p, 100 + p, 200 + p, 300 + p};
    Transfinite Curve {1000 + p} = along;
  EndFor
EndFor
Curve Loop(2000) = {1, 1002, -301, -1000};     Surface(2000) = {2000};  // pressure side
Curve Loop(2001) = {11, 1012, -311, -1010};    Surface(2001) = {2001};  // suction side
Curve Loop(2002) = {21, 1010, -321, -1000};    Surface(2002) = {2002};  // leading edge
Curve Loop(2003) = {22, 1012, -322, -1002};    Surface(2003) = {2003};  // trailing edge
Transfinite Surface {1, 301, 2000, 2001, 2002, 2003};
Recombine Surface {1, 301, 2000, 2001, 2002, 2003};
Surface Loop(1) = {1, 301, 2000, 2001, 2002, 2003};
Volume(1) = {1};
Transfinite Volume {1};

Physical Volume("blade") = {1};
Physical Surface("root") = {1};
Physical Surface("tip") = {301};
Physical Surface("pressure side") = {2000};
