#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "drives.h"
#include "flownav/config/make_state.h"
#include "flownav/io/field_source.h"
#include "rawlog_files.h"
#include "view_model.h"

namespace flownav::testing {

inline const std::filesystem::path& corridor() {
    static const std::filesystem::path file = FLOWNAV_CORRIDOR;
    return file;
}

/// A drive with obstacles whose background reader works in work() only.
inline view::ViewOptions view_options(const std::filesystem::path& file = corridor()) {
    view::ViewOptions options;
    options.input = file;
    options.way = view::BackgroundReader::Way::Asked;
    return options;
}

/// Runs the background reader to its end.
inline void finish(view::ViewModel& model) {
    while (model.work(1000)) {
    }
    model.poll();
}

/// Runs the file through one pipeline, as flownav-replay does, and returns the records.
inline std::vector<pipeline::Step> straight_run(const std::filesystem::path& file,
                                                const config::Config& config = {}) {
    io::RawlogReader reader(file);
    io::FieldSource source(reader, config.camera);
    pipeline::State state = config::make_state(config);
    std::vector<pipeline::Step> steps;
    while (const auto event = source.next()) {
        if (const auto* field = std::get_if<Field>(&*event)) steps.push_back(pipeline::step(state, *field));
    }
    return steps;
}

inline std::string bytes_of_file(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << stream.rdbuf();
    return bytes.str();
}

/// Writes the first part of the corridor, cut inside an object.
inline std::filesystem::path cut_corridor(double share) {
    const auto file = test_folder() / "cut.rawlog";
    const std::string all = bytes_of_file(corridor());
    write_bytes(file, all.substr(0, static_cast<std::size_t>(share * static_cast<double>(all.size()))));
    return file;
}

}  // namespace flownav::testing
