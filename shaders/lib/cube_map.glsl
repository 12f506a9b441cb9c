// Cube maps: the sphere on six square faces, +X -X +Y -Y +Z -Z of right-handed axes, stacked in this order from the top
// of a picture as OpenEXR's cube environment maps lay them out. A place on a face is (right, up), -1 to 1 from edge to
// edge; the place of the texel in column i and row j of n is ((2 i + 1) / n - 1, 1 - (2 j + 1) / n).

// The axes of face 0 to 5. Columns: picture right, picture up, outward.
FN PMat3 cube_face_axes(int face) {
  PVec3 x = PVec3(PReal(1.0), PReal(0.0), PReal(0.0));
  PVec3 y = PVec3(PReal(0.0), PReal(1.0), PReal(0.0));
  PVec3 z = PVec3(PReal(0.0), PReal(0.0), PReal(1.0));
  if (face == 0) {
    return PMat3(z, y, x);
  }
  if (face == 1) {
    return PMat3(-z, y, -x);
  }
  if (face == 2) {
    return PMat3(x, z, y);
  }
  if (face == 3) {
    return PMat3(x, -z, -y);
  }
  if (face == 4) {
    return PMat3(-x, y, z);
  }
  return PMat3(x, y, -z);
}

// The face whose outward axis is the rank-th nearest to the direction (rank 0 holds it, 1 and 2 may be touched by
// what surrounds it).
FN int cube_face(PVec3 direction, int rank) {
  PVec3 size = abs(direction);
  int largest = (size.x >= size.y && size.x >= size.z) ? 0 : (size.y >= size.z ? 1 : 2);
  int a = largest == 0 ? 1 : 0;
  int b = largest == 2 ? 1 : 2;
  bool a_first = (a == 0 ? size.x : size.y) >= (b == 1 ? size.y : size.z);
  int second = a_first ? a : b;
  int third = a_first ? b : a;
  int axis = rank == 0 ? largest : (rank == 1 ? second : third);
  if (axis == 0) {
    return direction.x >= PReal(0.0) ? 0 : 1;
  }
  if (axis == 1) {
    return direction.y >= PReal(0.0) ? 2 : 3;
  }
  return direction.z >= PReal(0.0) ? 4 : 5;
}

// The direction through a place of a face, not normalised: 1 along the outward axis.
FN PVec3 cube_direction(int face, PVec2 place) {
  return cube_face_axes(face) * PVec3(place.x, place.y, PReal(1.0));
}

// OpenGL lays a cube's faces out as above, but left-handed: the direction in which it finds one of right-handed axes, in a
// texture whose last two faces are exchanged.
FN vec3 opengl_cube_direction(vec3 direction) { return vec3(direction.x, direction.y, -direction.z); }

// How many times a map of n texels along a face's side is to be halved until its texels are on the average (by the root
// of their solid angle) as wide as `width_rad`; less than 0 where the map itself is coarser. It does not tell apart where
// on a face they lie, 0.6 to 1.4 of that wide: light would be lost and won from one size to the next.
FN Real cube_level(Real width_rad, Real n) { return log2(n * width_rad / Real(1.4472025)); } // sqrt(4 pi / 6)
