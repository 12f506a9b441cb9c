// What the stages of a disc share; the C++ twin is DiscBlock in renderer/gpu/disc_pass.cpp.
const int disc_most_boxes = 6; // the faces of a cube

layout(std140, binding = 0) uniform DiscBlock {
  DiscFrame disc;
  RefractionFrame refraction;
  StarExtinctionFrame extinction;
  vec4 optical_depth; // of one zenith column, of the cheap tier; zero for no air
  vec2 size;          // of the picture
  float focal;
  float height_km;    // of the observer
  vec2 strip;         // first row and number of rows that the framebuffer holds
  float cells_of_radius; // into which a small disc's radius is cut for its light, at least
  vec4 boxes[disc_most_boxes]; // low x, low y, high x, high y
} block;
