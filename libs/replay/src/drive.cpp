#include "flownav/replay/drive.h"

#include <algorithm>

namespace flownav {

const char* end_word(const Drive& drive) {
    if (!drive.stop_reason.empty()) return "unusable_image";
    switch (drive.end.kind) {
        case ReadEnd::Kind::NotYet:
            return "not_at_end";
        case ReadEnd::Kind::Clean:
            return "clean";
        case ReadEnd::Kind::Truncated:
            return "truncated";
        case ReadEnd::Kind::Corrupt:
            return "corrupt";
        case ReadEnd::Kind::UnknownClass:
            return "unknown_class";
    }
    return "unknown";
}

std::string end_sentence(const Drive& drive) {
    const bool stopped = !drive.stop_reason.empty();
    const std::string objects = std::to_string(drive.end.objects_read) + " objects";
    if (drive.end.kind == ReadEnd::Kind::Clean && !stopped) {
        return "The input was read to its clean end (" + objects + ").";
    }
    const std::string problem = "The input could not be read to its end: ";
    if (!stopped) return problem + drive.end.message;
    return problem + drive.stop_reason + ". What came before was used.";
}

std::vector<std::uint64_t> status_counts(const std::vector<FieldRow>& rows) {
    std::vector<std::uint64_t> counts;
    for (const FieldStatus status : all_field_statuses) {
        const auto same = [status](const FieldRow& row) { return row.status == status; };
        counts.push_back(static_cast<std::uint64_t>(std::count_if(rows.begin(), rows.end(), same)));
    }
    return counts;
}

const char* explain(FieldStatus status) {
    switch (status) {
        case FieldStatus::Ok:
            return "The turn rate was measured with this field.";
        case FieldStatus::Waiting:
            return "The first field, or the first after a gap: there is nothing to compare it with yet.";
        case FieldStatus::Lost:
            return "There were vectors, but no common motion explains them: very fast turns, a mover that "
                   "fills "
                   "the view, or a wrong camera pose.";
        case FieldStatus::NoTexture:
            return "Too few unambiguous vectors: a smooth floor, darkness or motion blur.";
        case FieldStatus::BadField:
            return "Black, saturated or constant: not a picture.";
    }
    return "";
}

}  // namespace flownav
