// An angle bracket held at its bolt hole, standing on four pads, of tetrahedra of ten nodes. Lengths in metres.
// gmsh -3 -order 2 -format msh41 angle-bracket.geo -o angle-bracket.msh
SetFactory("OpenCASCADE");

length = 0.080; width = 0.060; foot = 0.010; height = 0.080; wall = 0.008;
pad_x = 0.006; pad_y = 0.010; relief = 0.001;  // sides of the pads, depth of what is milled away between them
hole = 0.006; rib = 0.020;        // radius of the hole, legs of the fillet

Box(1) = {0, 0, 0, length, width, foot};
Box(2) = {0, 0, 0, wall, width, height};
Box(3) = {pad_x, 0, 0, length - 2 * pad_x, width, relief};
Box(5) = {0, pad_y, 0, length, width - 2 * pad_y, relief};
Cylinder(4) = {0.045, 0.5 * width, 0, 0, 0, foot, hole};
// The fillet between foot and wall: a prism of triangular section.
Point(101) = {wall, 0, foot}; Point(102) = {wall + rib, 0, foot}; Point(103) = {wall, 0, foot + rib};
Line(101) = {101, 102}; Line(102) = {102, 103}; Line(103) = {103, 101};
Curve Loop(101) = {101, 102, 103}; Plane Surface(101) = {101};
fillet[] = Extrude {0, width, 0} { Surface{101}; };
BooleanUnion(10) = { Volume{1}; Delete; }{ Volume{2, fillet[1]}; Delete; };
BooleanDifference(11) = { Volume{10}; Delete; }{ Volume{3, 4, 5}; Delete; };

small = 0.0005;
pads[] = Surface In BoundingBox {-small, -small, -small, length + small, width + small, small};
holes[] = Surface In BoundingBox {0.045 - hole - small, 0.5 * width - hole - small, -small, 0.045 + hole + small, 0.5 * width + hole + small, foot + small};
top[] = Surface In BoundingBox {-small, -small, height - small, wall + small, width + small, height + small};
MeshSize {:} = 0.0055;
Physical Volume("bracket") = {11};
Physical Surface("pads") = {pads[]};
Physical Surface("bolt hole") = {holes[]};
Physical Surface("top") = {top[]};
