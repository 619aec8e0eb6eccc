// Declares the functions of OpenGL 3, too
#define GL_GLEXT_PROTOTYPES 1
#include "floor_light_gl.h"

#include <GL/gl.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace flownav::sim {
namespace {

using Eigen::Vector2d;

/// Height at which light is drawn, above tape, paper and mats.
constexpr double light_height_m = 0.0015;

/// Most sides of a shadow: twice the corners of a cylinder's rim, and room for footprints.
constexpr int sides_max = 64;

constexpr const char* vertex_source = R"(#version 130
uniform mat4 pmv;
uniform vec2 low;
uniform vec2 high;
uniform float height;
out vec2 at;
void main() {
    at = vec2((gl_VertexID & 1) == 0 ? low.x : high.x, gl_VertexID < 2 ? low.y : high.y);
    gl_Position = pmv * vec4(at, height, 1.0);
}
)";

constexpr const char* shadow_source = R"(#version 130
uniform vec3 sides[64];
uniform int count;
uniform float loss;
uniform float soft;
in vec2 at;
out vec4 colour;
void main() {
    float inside = 1e9;
    for (int i = 0; i < count; ++i) inside = min(inside, sides[i].z - dot(sides[i].xy, at));
    colour = vec4(vec3(1.0 - loss * clamp(0.5 + inside / soft, 0.0, 1.0)), 1.0);
}
)";

constexpr const char* spot_source = R"(#version 130
uniform vec2 centre;
uniform vec4 to_sigmas;
uniform float grey;
in vec2 at;
out vec4 colour;
void main() {
    vec2 off = at - centre;
    vec2 sigmas = vec2(dot(to_sigmas.xy, off), dot(to_sigmas.zw, off));
    colour = vec4(vec3(grey * exp(-dot(sigmas, sigmas) / 2.0)), 1.0);
}
)";

unsigned int compiled(unsigned int kind, const char* source) {
    const unsigned int shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    int fine = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &fine);
    if (fine == 0)
        throw std::runtime_error("simulated camera: OpenGL refuses the shader of shadows; needs GLSL 1.30");
    return shader;
}

unsigned int linked(const char* fragment_source) {
    const unsigned int program = glCreateProgram();
    glAttachShader(program, compiled(GL_VERTEX_SHADER, vertex_source));
    glAttachShader(program, compiled(GL_FRAGMENT_SHADER, fragment_source));
    glLinkProgram(program);
    int fine = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &fine);
    if (fine == 0) throw std::runtime_error("simulated camera: OpenGL does not link the shaders of shadows");
    return program;
}

float as_float(double value) {
    return static_cast<float>(value);
}

/// Uniforms of the program in use.
class Uniforms {
  public:
    explicit Uniforms(unsigned int program) : program_(program) {}
    int at(const char* name) const { return glGetUniformLocation(program_, name); }
    void set(const char* name, double value) const { glUniform1f(at(name), as_float(value)); }
    void set(const char* name, const Vector2d& v) const {
        glUniform2f(at(name), as_float(v.x()), as_float(v.y()));
    }

  private:
    unsigned int program_;
};

void draw_rectangle(const Uniforms& uniforms, const Vector2d& low_m, const Vector2d& high_m) {
    uniforms.set("low", low_m);
    uniforms.set("high", high_m);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void draw(const Uniforms& uniforms, const FloorShadow& shadow) {
    std::vector<float> sides;
    for (const Eigen::Vector3d& side : shadow.sides)
        for (const double value : {side.x(), side.y(), side.z()}) sides.push_back(as_float(value));
    const int count = std::min(static_cast<int>(shadow.sides.size()), sides_max);
    glUniform3fv(uniforms.at("sides"), count, sides.data());
    glUniform1i(uniforms.at("count"), count);
    uniforms.set("loss", shadow.loss);
    uniforms.set("soft", std::max(shadow.soft_m, 1e-4));
    draw_rectangle(uniforms, shadow.extent_m.min(), shadow.extent_m.max());
}

void draw(const Uniforms& uniforms, const FloorSpot& spot) {
    const Eigen::Matrix2d& m = spot.to_sigmas;
    uniforms.set("centre", spot.centre_m);
    glUniform4f(uniforms.at("to_sigmas"), as_float(m(0, 0)), as_float(m(0, 1)), as_float(m(1, 0)),
                as_float(m(1, 1)));
    uniforms.set("grey", spot.grey / 255.0);
    const Vector2d reach = Vector2d::Constant(spot.reach_m);
    draw_rectangle(uniforms, spot.centre_m - reach, spot.centre_m + reach);
}

template <class Items>
void draw_all(unsigned int program, const Items& items, const std::array<float, 16>& pmv) {
    glUseProgram(program);
    const Uniforms uniforms(program);
    glUniformMatrix4fv(uniforms.at("pmv"), 1, GL_FALSE, pmv.data());
    uniforms.set("height", light_height_m);
    for (const auto& item : items) draw(uniforms, item);
}

}  // namespace

void FloorLightPainter::paint(const FloorLight& light, const std::array<float, 16>& pmv) {
    if (light.empty()) return;
    if (shadow_program_ == 0) {
        shadow_program_ = linked(shadow_source);
        spot_program_ = linked(spot_source);
    }
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    draw_all(shadow_program_, light.shadows(), pmv);
    glBlendFunc(GL_ONE, GL_ONE);
    draw_all(spot_program_, light.spots(), pmv);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

}  // namespace flownav::sim
