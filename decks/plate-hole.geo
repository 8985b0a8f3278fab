// SPDX-License-Identifier: GPL-3.0-or-later
// A quarter of a plate with a hole of radius 1, half as wide as 10 and half as long as 20, of 9-node quadrangles:
// gmsh -2 -order 2 -format msh41 plate-hole.geo -o plate-hole.msh
around = 8; // elements along an eighth of the hole
across = 14; // from the hole outwards, each 1.25 times as large as the one before
s = Sqrt(0.5);
Point(1) = {0, 0, 0};
Point(2) = {1, 0, 0};
Point(3) = {s, s, 0};
Point(4) = {0, 1, 0};
Point(5) = {10, 0, 0};
Point(6) = {10, 10, 0};
Point(7) = {0, 10, 0};
Point(8) = {20, 0, 0};
Point(9) = {20, 10, 0};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Line(3) = {2, 5};
Line(4) = {3, 6};
Line(5) = {4, 7};
Line(6) = {5, 6};
Line(7) = {6, 7};
Line(8) = {5, 8};
Line(9) = {6, 9};
Line(10) = {8, 9};
Curve Loop(1) = {3, 6, -4, -1};
Curve Loop(2) = {4, 7, -5, -2};
Curve Loop(3) = {8, 10, -9, -6};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Plane Surface(3) = {3};
Transfinite Curve {1, 2, 6, 7, 10} = around + 1;
Transfinite Curve {3, 4, 5} = across + 1 Using Progression 1.25;
Transfinite Curve {8, 9} = 7;
Transfinite Surface {1, 2, 3};
Recombine Surface {1, 2, 3};
Physical Surface("plate", 1) = {1, 2, 3};
Physical Curve("below", 11) = {3, 8};
Physical Curve("left", 12) = {5};
Physical Curve("pulled", 13) = {10};
Physical Curve("hole", 14) = {1, 2};
