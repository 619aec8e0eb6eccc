#include <flownav/core/version.h>
#include <flownav/pipeline/pipeline.h>

#include <cstdint>
#include <cstdio>
#include <vector>

int main() {
    flownav::Field field;
    field.camera.width_px = 320;
    field.camera.height_px = 240;
    field.camera.fx_px = field.camera.fy_px = 300.0;
    field.camera.cx_px = 159.5;
    field.camera.cy_px = 119.5;
    field.camera.mount.height_m = 0.5;
    field.camera.mount.pitch_rad = 0.4;

    flownav::pipeline::State state{flownav::pipeline::Params{}};
    std::vector<std::uint8_t> pixels(320 * 240);
    for (int i = 0; i < 5; ++i) {
        for (std::size_t p = 0; p < pixels.size(); ++p)
            pixels[p] = static_cast<std::uint8_t>((p * 2654435761U) >> 13U);
        field.timestamp_s = 0.04 * i;
        field.image = {pixels.data(), 320, 240, 320};
        const auto& record = flownav::pipeline::step(state, field);
        std::printf("%.2f s: %s\n", record.timestamp_s, flownav::to_string(record.status));
    }
    std::printf("flownav %s\n", flownav::version());
}
