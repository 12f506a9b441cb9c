// The directions from which light is gathered at a light field's nodes. Buffers hold the blocks of a place together.
layout(local_size_x = 32) in;

layout(location = 1) uniform int directions; // of a node
layout(location = 2) uniform int angles;     // nodes of a height

layout(std430, binding = 0) buffer Radiances { vec4 radiances[]; };                           // by node, direction
layout(std430, binding = 1) readonly buffer Directions { LightDirection directions_from[]; }; // by height, direction
