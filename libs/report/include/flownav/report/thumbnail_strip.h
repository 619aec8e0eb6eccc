#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <future>
#include <vector>

#include "flownav/core/field.h"
#include "flownav/core/strip_counts.h"
#include "flownav/evaluation/field_row.h"
#include "flownav/pipeline/step.h"
#include "flownav/report/contact_segments.h"
#include "flownav/report/held_contacts.h"

namespace flownav::report {

/// Annotated fields of a drive of unknown length for report.html: one every half second or so. Once the
/// pictures need more than `most_bytes` all become smaller, and then rarer. Ends of cycles are preferred, as
/// they show obstacles. Of what was offered only pictures stay in memory.
class ThumbnailStrip {
  public:
    static constexpr std::size_t most_bytes = 3'100'000;

    struct Picture {
        double timestamp_s = 0.0;
        evaluation::LabelCounts labels{};       ///< blocks that the picture shows, by label
        std::vector<Eigen::Vector2d> points_m;  ///< obstacle points, in the frame of the start
        StripCounts strips;                     ///< of the contact scan that the picture shows
        std::vector<ContactSegment> contacts;   ///< its contacts, in the frame of the start
        std::vector<std::uint8_t> jpeg;
    };

    /// `in_background`: pictures are drawn in a thread of their own, with the same result.
    explicit ThumbnailStrip(bool in_background = false) : in_background_(in_background) {}

    /// Considers one more field; they come with rising time stamps.
    void offer(const Field& field, const pipeline::Step& step);

    /// Waits for the last picture, after the last field.
    void finish() { settle(); }

    /// In order of time. A drive of a single field has one.
    const std::vector<Picture>& pictures() const { return pictures_; }

  private:
    bool is_due(const pipeline::Step& step) const;
    void settle();
    void make_room();
    void shrink();
    void thin_out();

    bool in_background_ = false;
    std::future<Picture> pending_;  ///< the last one, while it is being drawn
    HeldContacts contacts_;
    std::vector<Picture> pictures_;
    std::size_t bytes_ = 0;
    bool has_better_than_first_ = false;
    bool small_ = false;
    double interval_s_ = 0.5;
    double due_s_ = 0.0;
};

}  // namespace flownav::report
