// Luminance of a star in one pixel: its share of the light over the pixel's solid angle.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/star_psf.glsl"
#include "star_block.glsl"

flat in vec2 star_pixel;
flat in vec2 star_scale;
flat in vec4 star_light;
flat in float star_glare;

layout(location = 0) out vec4 luminance;
layout(location = 1) out vec4 point; // the same, where light of points is kept

void main() {
  PixelFrame frame = PixelFrame(PROJECTION, vec2(block.size), float(block.focal));
  vec2 pixel = gl_FragCoord.xy + vec2(0.0, block.strip.x);
  vec2 offset = pixel - star_pixel;
#ifdef CONSTANT_COLOR
  // The yardstick of the benchmark: the same billboards without a point-spread function.
  luminance = vec4(1.0);
#elif defined(CHEAP)
  float distance_px = length(offset);
  float core = mueller_intensity_psf(distance_px / mueller_radius);
  // The glare's unit is the intensity of a star of the control magnitude.
  float control_lux = zero_magnitude_lux * pow(2.512, -block.control_magnitude) /
                      (mueller_volume * mueller_radius * mueller_radius);
  float glare = star_glare * mueller_glare_psf(distance_px * star_scale.x) * control_lux / max(star_light.y, 1.0e-30);
  luminance = star_light * ((core + glare) * pixels_per_steradian(pixel, frame));
#else
  luminance = star_light * (psf_profile(offset * star_scale) * pixels_per_steradian(pixel, frame));
#endif
  point = luminance;
}
