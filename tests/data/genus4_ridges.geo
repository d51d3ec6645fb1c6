// A plate with sharp ridges and four holes: two round, one square, one hexagonal. Physical surfaces: 1 floor,
// 2 ceiling, 3 outer wall, 4.. walls of the holes.
//   gmsh -3 -setnumber size 0.3 genus4_ridges.geo -o genus4_ridges.mesh     (Gmsh 4.8.4), then blanks squeezed
SetFactory("OpenCASCADE");
If (!Exists(size))
  size = 0.12;
EndIf
height = 0.8;
// The plan: an L with one corner cut off.
Point(1) = {0, 0, 0};
Point(2) = {4, 0, 0};
Point(3) = {4, 1.5, 0};
Point(4) = {3.5, 2, 0};
Point(5) = {2, 2, 0};
Point(6) = {2, 4, 0};
Point(7) = {0, 4, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5}; Line(5) = {5, 6}; Line(6) = {6, 7};
Line(7) = {7, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7};
Circle(8) = {1.7, 0.9, 0, 0.45};
Curve Loop(2) = {8};
Circle(9) = {0.9, 3.1, 0, 0.45};
Curve Loop(3) = {9};
Point(20) = {2.7, 0.6, 0}; Point(21) = {3.3, 0.6, 0}; Point(22) = {3.3, 1.2, 0}; Point(23) = {2.7, 1.2, 0};
Line(20) = {20, 21}; Line(21) = {21, 22}; Line(22) = {22, 23}; Line(23) = {23, 20};
Curve Loop(4) = {20, 21, 22, 23};
For k In {0:5}
  Point(30 + k) = {0.75 + 0.4 * Cos(Pi / 3 * k), 1.85 + 0.4 * Sin(Pi / 3 * k), 0};
EndFor
For k In {0:5}
  Line(30 + k) = {30 + k, 30 + (k + 1) % 6};
EndFor
Curve Loop(5) = {30, 31, 32, 33, 34, 35};
Plane Surface(1) = {1, 2, 3, 4, 5};
out[] = Extrude {0, 0, height} { Surface{1}; };
e = 1e-3;
floor[] = Surface In BoundingBox {-e, -e, -e, 4 + e, 4 + e, e};
ceiling[] = Surface In BoundingBox {-e, -e, height - e, 4 + e, 4 + e, height + e};
round1[] = Surface In BoundingBox {1.2, 0.4, -e, 2.2, 1.4, height + e};
round2[] = Surface In BoundingBox {0.4, 2.6, -e, 1.4, 3.6, height + e};
square[] = Surface In BoundingBox {2.7 - e, 0.6 - e, -e, 3.3 + e, 1.2 + e, height + e};
hexagon[] = Surface In BoundingBox {0.3, 1.4, -e, 1.2, 2.3, height + e};
outer[] = Surface{:};
outer[] -= floor[]; outer[] -= ceiling[]; outer[] -= round1[]; outer[] -= round2[]; outer[] -= square[];
outer[] -= hexagon[];
Physical Surface(1) = floor[];
Physical Surface(2) = ceiling[];
Physical Surface(3) = outer[];
Physical Surface(4) = round1[];
Physical Surface(5) = round2[];
Physical Surface(6) = square[];
Physical Surface(7) = hexagon[];
Physical Volume(1) = {1};
Mesh.MeshSizeMax = size;
Mesh.MeshSizeMin = size / 2;
Mesh.Algorithm = 6;
Mesh.OptimizeNetgen = 0;
Mesh.SaveElementTagType = 2;
