// Declares the functions of OpenGL 3, too
#define GL_GLEXT_PROTOTYPES 1
#include <GL/gl.h>
#include <mrpt/opengl/DefaultShaders.h>
#include <mrpt/opengl/Shader.h>

#include <cstddef>

#include "world_scene.h"

namespace flownav::sim {
namespace {

const void* at_byte(std::size_t offset) {
    return static_cast<const char*>(nullptr) + offset;
}

unsigned int make_texture(const cv::Mat1b& grey) {
    unsigned int name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, grey.cols, grey.rows, 0, GL_RED, GL_UNSIGNED_BYTE, grey.data);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_G, GL_RED);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_B, GL_RED);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    // The floor is seen at a slant, where mipmaps blur across as much as along: a little less of it.
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, -0.5F);
    glGenerateMipmap(GL_TEXTURE_2D);
    return name;
}

template <class T>
int bytes_of(const std::vector<T>& items) {
    return static_cast<int>(items.size() * sizeof(T));
}

}  // namespace

mrpt::opengl::shader_list_t WorldScene::requiredShaders() const {
    return {mrpt::opengl::DefaultShaderID::TEXTURED_TRIANGLES_NO_LIGHT};
}

void WorldScene::upload() const {
    glActiveTexture(GL_TEXTURE0);
    for (const TextureTile& tile : tiles_) texture_names_.push_back(make_texture(tile.grey));
    glGenVertexArrays(1, &array_);
    glBindVertexArray(array_);
    glGenBuffers(1, &index_buffer_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, bytes_of(indices_), indices_.data(), GL_STATIC_DRAW);
    glGenBuffers(1, &vertex_buffer_);
    glBindBuffer(GL_ARRAY_BUFFER, vertex_buffer_);
    glBufferData(GL_ARRAY_BUFFER, bytes_of(vertices_), vertices_.data(), GL_STATIC_DRAW);
}

void WorldScene::send_moved() const {
    for (const Drawn& drawn : drawn_) {
        const Part& part = parts_[drawn.part];
        if (part.own_vertices.empty()) continue;
        glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(part.first_vertex * sizeof(MeshVertex)),
                        bytes_of(part.own_vertices), &vertices_[part.first_vertex]);
    }
}

void WorldScene::render(const RenderContext& context) const {
    if (array_ == 0) upload();
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, vertex_buffer_);
    send_moved();
    const auto position = static_cast<GLuint>(context.shader->attributeId("position"));
    const auto uv = static_cast<GLuint>(context.shader->attributeId("vertexUV"));
    glEnableVertexAttribArray(position);
    glVertexAttribPointer(position, 3, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), at_byte(0));
    glEnableVertexAttribArray(uv);
    glVertexAttribPointer(uv, 2, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), at_byte(offsetof(MeshVertex, u)));
    glUniform1i(context.shader->uniformId("textureSampler"), 0);
    glActiveTexture(GL_TEXTURE0);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    for (const Drawn& drawn : drawn_) {
        if (drawn.part == 0) draw(lids_);
        draw(drawn);
    }
    draw_light(context);
    glDisable(GL_CULL_FACE);
    glDisableVertexAttribArray(position);
    glDisableVertexAttribArray(uv);
    glBindVertexArray(0);
}

void WorldScene::draw(const Drawn& drawn) const {
    const Part& part = parts_[drawn.part];
    glBindTexture(GL_TEXTURE_2D, texture_names_[part.texture]);
    glDrawElements(GL_TRIANGLES, part.indices[drawn.detail], GL_UNSIGNED_INT,
                   at_byte(part.first_index[drawn.detail] * sizeof(std::uint32_t)));
}

/// Nearer by a step of the depth buffer than the floor in the same place.
void WorldScene::draw(const Lids& lids) const {
    if (lids.indices == 0) return;
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1.0F, -1.0F);
    glDrawElements(GL_TRIANGLES, lids.indices, GL_UNSIGNED_INT,
                   at_byte(lids.first_index * sizeof(std::uint32_t)));
    glDisable(GL_POLYGON_OFFSET_FILL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void WorldScene::draw_light(const RenderContext& context) const {
    if (!light_ || light_->empty()) return;
    draw(light_lids_);
    std::array<float, 16> pmv{};
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            pmv[static_cast<std::size_t>(4 * column + row)] = context.state->pmv_matrix(row, column);
    light_painter_.paint(*light_, pmv);
    glUseProgram(context.shader->programId());
}

}  // namespace flownav::sim
