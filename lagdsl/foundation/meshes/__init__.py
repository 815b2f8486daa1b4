"""Files of triangles that a `draw mesh` names: STL, OBJ, COLLADA."""
