#include "vesper/gpu/light_gatherer.hpp"

#include "vesper/base/error.hpp"

#include <algorithm>
#include <epoxy/gl.h>
#include <span>
#include <vector>

namespace vesper::gpu {
namespace {

/// LightRay of shaders/light_rays.glsl.
struct RayRecord {
  f32::LightStep ground;
  int first_step;
  int steps;
  int meets_ground;
  float cos_zenith;
};
static_assert(sizeof(f32::LightStep) == 32 && sizeof(RayRecord) == 48);
static_assert(sizeof(f32::LightDirection) == 16 && sizeof(f32::LightSums) == 80 && sizeof(Lanes) == 16);

template <class T> Buffer buffer_of(const std::vector<T>& items) {
  // OpenGL has no empty buffers.
  return items.empty() ? make_dynamic_buffer(sizeof(Lanes)) : make_static_buffer(std::as_bytes(std::span(items)));
}

template <class T> void read_buffer(const Buffer& buffer, std::vector<T>& items) {
  glGetNamedBufferSubData(buffer.name(), 0, static_cast<GLsizeiptr>(items.size() * sizeof(T)), items.data());
}

void bind(unsigned int binding, const Buffer& buffer) {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer.name());
}

int whole(std::size_t count) { return static_cast<int>(count); }

} // namespace

GpuLightGatherer::Rule::Rule(const LightFieldModel& model, const LightRule& rule)
    : directions(whole(rule.size())), zeniths(whole(rule.zeniths)), directions_from(buffer_of(rule.directions)),
      phase_matrix(buffer_of(rule.phase_matrix)),
      radiances(make_dynamic_buffer(model.nodes() * rule.size() * model.blocks() * sizeof(Lanes))) {
  std::vector<RayRecord> records;
  std::vector<f32::LightStep> all_steps;
  std::vector<Lanes> all_weights;
  std::vector<Lanes> all_ground_weights;
  for (const LightRay& ray : rule.rays) {
    records.push_back({ray.ground, whole(all_steps.size()), whole(ray.steps.size()), ray.meets_ground ? 1 : 0,
                       static_cast<float>(ray.cos_zenith)});
    all_steps.insert(all_steps.end(), ray.steps.begin(), ray.steps.end());
    all_weights.insert(all_weights.end(), ray.weights.begin(), ray.weights.end());
    std::vector<Lanes> ground = ray.ground_weights;
    ground.resize(model.blocks());
    all_ground_weights.insert(all_ground_weights.end(), ground.begin(), ground.end());
  }
  rays = buffer_of(records);
  steps = buffer_of(all_steps);
  weights = buffer_of(all_weights);
  ground_weights = buffer_of(all_ground_weights);
}

GpuLightGatherer::Table GpuLightGatherer::make_table(std::size_t bytes, int channels) {
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  if (bytes / (sizeof(float) * static_cast<std::size_t>(channels)) > static_cast<std::size_t>(most)) {
    throw Error(ErrorKind::gpu, "a light field's tables exceed the driver's buffer textures",
                {"", "", "Solve it on the processor, or with fewer wavelengths"});
  }
  Table table;
  table.buffer = make_dynamic_buffer(std::max(bytes, sizeof(Lanes)));
  table.texture = make_buffer_texture(table.buffer, channels);
  return table;
}

GpuLightGatherer::GpuLightGatherer(const ShaderLibrary& library, const LightFieldModel& model)
    : model_(model), once_(build_program(library, {"light_once.comp"})),
      again_(build_program(library, {"light_again.comp"})), sum_(build_program(library, {"light_sums.comp"})),
      first_rule_(model, model.first_rule(0)), later_rule_(model, model.later_rule(0)),
      second_moments_(buffer_of(model.second_moment())) {
  std::vector<float> cosines;
  for (std::size_t angle = 0; angle < model.angles(); ++angle) {
    cosines.push_back(static_cast<float>(model.angle_cos(angle)));
  }
  cosines_ = buffer_of(cosines);
  std::vector<Lanes> parameters(model.scatterers() * model.blocks());
  for (std::size_t s = 0; s < model.scatterers(); ++s) {
    model.phase_parameter(s, &parameters[s * model.blocks()]);
    glProgramUniform1i(once_.name(), 8 + whole(s), static_cast<int>(model.phase_kind(s)));
  }
  parameters_ = buffer_of(parameters);
  const LightFieldSums sums(model);
  moments_ = buffer_of(sums.moments);
  sources_ = buffer_of(sums.sources);
  const std::size_t light = sizeof(Lanes);
  places_ = make_table(model.angle_places().size() * sizeof(float), 1);
  update_buffer(places_.buffer, std::as_bytes(std::span(model.angle_places())));
  depths_ = make_table(model.depths().size() * light, 4);
  update_buffer(depths_.buffer, std::as_bytes(std::span(model.depths())));
  field_table_ = make_table(sums.moments.size() * f32::field_moments * light, 4);
  source_table_ = make_table(sums.sources.size() * light, 4);
  ground_table_ = make_table(model.angles() * model.blocks() * light, 4);
}

void GpuLightGatherer::gather(const ProgramHandle& program, const Rule& rule, LightFieldSums& sums) const {
  constexpr int group = 32;
  const auto groups = [](int count) { return static_cast<GLuint>((count + group - 1) / group); };
  const auto nodes = static_cast<GLuint>(model_.nodes());
  const auto blocks = static_cast<GLuint>(model_.blocks());
  for (const ProgramHandle* own : {&program, &sum_}) {
    glProgramUniform1i(own->name(), 0, whole(model_.blocks()));
    glProgramUniform1i(own->name(), 1, rule.directions);
    glProgramUniform1i(own->name(), 2, whole(model_.angles()));
  }
  glProgramUniform1i(program.name(), 3, rule.zeniths);
  glProgramUniform1i(program.name(), 4, whole(model_.scatterers()));
  glProgramUniform1f(program.name(), 5, model_.shell().ground_km);
  glProgramUniform1f(program.name(), 6, model_.shell().top_km);
  glProgramUniform1i(sum_.name(), 3, whole(model_.source_heights() * model_.angles()));
  bind(0, rule.radiances);
  bind(1, rule.directions_from);
  bind(2, rule.rays);
  bind(3, rule.steps);
  bind(4, rule.weights);
  bind(5, rule.ground_weights);
  bind(6, cosines_);
  glUseProgram(program.name());
  glDispatchCompute(groups(rule.directions), nodes, blocks);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  bind(2, moments_);
  bind(3, sources_);
  bind(4, rule.phase_matrix);
  glUseProgram(sum_.name());
  glDispatchCompute(groups(1 + whole(LightFieldModel::source_directions)), nodes, blocks);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  read_buffer(moments_, sums.moments);
  read_buffer(sources_, sums.sources);
  require_no_error("gathering light");
}

void GpuLightGatherer::gather_once(LightFieldSums& sums) {
  glProgramUniform1f(once_.name(), 7, LightFieldModel::light_radius_rad);
  glBindTextureUnit(1, depths_.texture.name());
  bind(7, parameters_);
  gather(once_, first_rule_, sums);
}

void GpuLightGatherer::gather_again(const LightFieldTables& tables, LightFieldSums& sums) {
  update_buffer(field_table_.buffer, std::as_bytes(std::span(tables.field)));
  update_buffer(source_table_.buffer, std::as_bytes(std::span(tables.sources)));
  update_buffer(ground_table_.buffer, std::as_bytes(std::span(tables.ground)));
  glBindTextureUnit(0, places_.texture.name());
  glBindTextureUnit(2, field_table_.texture.name());
  glBindTextureUnit(3, source_table_.texture.name());
  glBindTextureUnit(4, ground_table_.texture.name());
  bind(7, second_moments_);
  gather(again_, later_rule_, sums);
}

} // namespace vesper::gpu
