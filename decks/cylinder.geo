// SPDX-License-Identifier: GPL-3.0-or-later
// A channel of 2.2 x .41 with a round hole of radius .05 about (.2, .2), of quadrangles that are finer near the hole:
// gmsh -2 -order 2 -format msh41 cylinder.geo -o cylinder.msh
near = .0045;  // size of the elements at the hole, before each is divided into four or joined in pairs
growth = .23;  // by which they grow away from it, per length
r = .05;
x = .2;
y = .2;
Point(1) = {0, 0, 0};
Point(2) = {2.2, 0, 0};
Point(3) = {2.2, .41, 0};
Point(4) = {0, .41, 0};
Point(5) = {x, y, 0};
Point(6) = {x + r, y, 0};
Point(7) = {x, y + r, 0};
Point(8) = {x - r, y, 0};
Point(9) = {x, y - r, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Circle(5) = {6, 5, 7};
Circle(6) = {7, 5, 8};
Circle(7) = {8, 5, 9};
Circle(8) = {9, 5, 6};
Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {5, 6, 7, 8};
Plane Surface(1) = {1, 2};
Field[1] = Distance;
Field[1].CurvesList = {5, 6, 7, 8};
Field[1].NumPointsPerCurve = 100;
Field[2] = MathEval;
Field[2].F = Sprintf("%g + %g*F1", near, growth);
Field[3] = MathEval;
Field[3].F = "0.06 + 0.04*x";
Field[4] = Min;
Field[4].FieldsList = {2, 3};
Background Field = 4;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6;              // triangles by Delaunay's rule from the edges inwards
Mesh.RecombinationAlgorithm = 3; // and quadrangles of all of them
Recombine Surface {1};
Physical Surface("fluid", 1) = {1};
Physical Curve("inflow", 11) = {4};
Physical Curve("outflow", 12) = {2};
Physical Curve("cylinder", 13) = {5, 6, 7, 8};
