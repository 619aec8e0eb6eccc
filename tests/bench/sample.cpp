#include "sample.h"

#include <cstdlib>

#include "flownav/io/field_source.h"

namespace flownav::bench {

std::filesystem::path data_folder() {
    const char* data = std::getenv("FLOWNAV_DATA");
    return data ? data : FLOWNAV_DATA;
}

std::filesystem::path sample_rawlog() {
    auto field = data_folder() / "scenes" / "field.rawlog";
    if (std::filesystem::exists(field)) return field;
    return std::filesystem::path(FLOWNAV_SHARE) / "datasets" / "corridor.rawlog";
}

std::vector<Field> read_fields(const std::filesystem::path& rawlog) {
    io::RawlogReader reader(rawlog);
    io::FieldSource source(reader, {});
    std::vector<Field> fields;
    while (const auto event = source.next()) {
        if (const auto* field = std::get_if<Field>(&*event)) fields.push_back(*field);
    }
    return fields;
}

const std::vector<Field>& sample_fields() {
    static const std::vector<Field> fields = read_fields(sample_rawlog());
    return fields;
}

}  // namespace flownav::bench
