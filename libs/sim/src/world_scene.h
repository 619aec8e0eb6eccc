#pragma once

#include <mrpt/opengl/CSetOfTexturedTriangles.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "floor_light_gl.h"
#include "flownav/sim/ground.h"
#include "flownav/sim/world.h"
#include "raycast/floor_light.h"
#include "solid_mesh.h"
#include "texture_tile.h"

namespace flownav::sim {

/// The half spaces that hold all a camera sees, by their normals, which point inward; its eye lies on all.
struct ViewPyramid {
    Eigen::Vector3d eye_m = Eigen::Vector3d::Zero();
    std::array<Eigen::Vector3d, 4> inward;
};

/// A world as one object of MRPT's: all meshes in one buffer, textures with mipmaps (MRPT's own have none),
/// drawn from near to far without what is out of view, as a software renderer needs it. The names it takes
/// from OpenGL die with the context of the renderer.
class WorldScene : public mrpt::opengl::CSetOfTexturedTriangles {
  public:
    explicit WorldScene(const World& world);

    /// Moves what moves, and chooses what to draw, in the given light.
    void look(const ViewPyramid& view, FloorLight light, double time_s);

    mrpt::opengl::shader_list_t requiredShaders() const override;
    void render(const RenderContext& context) const override;
    void renderUpdateBuffers() const override {}
    void onUpdateBuffers_TexturedTriangles() override {}
    void initializeTextures() const override {}
    void freeOpenGLResources() override {}
    mrpt::math::TBoundingBoxf internalBoundingBoxLocal() const override;

  private:
    struct Part {
        Solid solid;
        double radius_m = 0.0;  ///< of a sphere around it
        std::size_t texture = 0;
        std::array<std::size_t, 2> first_index{};  ///< of the fine mesh and of the coarse one
        std::array<int, 2> indices{};
        std::size_t first_vertex = 0;          ///< of both
        std::vector<MeshVertex> own_vertices;  ///< in the solid's frame, when it moves
    };
    struct Drawn {
        double distance_m = 0.0;
        std::size_t part = 0;
        int detail = 0;
    };

    /// Flat pieces over the openings of the floor that fill the depth buffer only.
    struct Lids {
        std::size_t first_index = 0;
        int indices = 0;
    };

    std::size_t texture_of(const Look& look, const TileGrid& grid);
    void add_floor(const World& world);
    void add_ground(const World& world);
    void add_quad(const std::array<Eigen::Vector3d, 4>& corners_m, const std::array<Eigen::Vector2d, 4>& uv_m,
                  const Look& look);
    Lids make_lids(const World& world, double height_m);
    void draw(const Drawn& drawn) const;
    void draw(const Lids& lids) const;
    void draw_light(const RenderContext& context) const;
    void add_solid(const Solid& solid);
    void place(Part& part, double time_s);
    void upload() const;
    void send_moved() const;

    std::vector<Part> parts_;  ///< the first one is the floor
    std::vector<TextureTile> tiles_;
    std::map<std::array<int, 3>, std::size_t> tile_of_;
    std::vector<MeshVertex> vertices_;  ///< in the world frame
    std::vector<std::uint32_t> indices_;
    std::vector<Drawn> drawn_;
    Lids lids_;        ///< keep the floor out of its openings
    Lids light_lids_;  ///< keep light that lies on the floor out of them
    std::optional<FloorLight> light_;

    mutable FloorLightPainter light_painter_;
    mutable std::vector<unsigned int> texture_names_;
    mutable unsigned int vertex_buffer_ = 0;
    mutable unsigned int index_buffer_ = 0;
    mutable unsigned int array_ = 0;
};

}  // namespace flownav::sim
