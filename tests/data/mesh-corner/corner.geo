// An angle of two tapering arms, straight-sided: its frequencies are those of an independent program, see
// tests/problems/assembly/solid_test.cpp. gmsh -3 -order 2 -format msh41 corner.geo
Point(1) = {0, 0, 0};
Point(2) = {0.12, 0, 0};
Point(3) = {0.12, 0.02, 0};
Point(4) = {0.03, 0.025, 0};
Point(5) = {0.022, 0.1, 0};
Point(6) = {0, 0.1, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6};
Plane Surface(1) = {1};
body[] = Extrude {0.004, 0.002, 0.03} { Surface{1}; };
Physical Volume("corner") = {body[1]};
Physical Surface("foot") = {body[3]};
Physical Surface("top") = {body[6]};
Mesh.MeshSizeMin = 0.03;
Mesh.MeshSizeMax = 0.03;
