#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "flownav/evaluation/field_row.h"

namespace flownav::evaluation {

/// Figures of the contact scans of a drive. Means are over the scanned cycles, and empty when there are none.
struct ContactFigures {
    std::uint64_t scans = 0;                ///< contact scans, those behind a closed gate included
    std::uint64_t rows = 0;                 ///< strips of the scanned cycles: rows of contacts.csv
    std::optional<double> scanned_percent;  ///< of the finished cycles: those that were scanned
    std::array<std::uint64_t, all_contact_gates.size()> by_gate{};  ///< scans, in the order of ContactGate
    std::optional<double> free_strips;                              ///< mean number in a cycle
    std::optional<double> contacts;         ///< strips that end at an obstacle, mean in a cycle
    std::optional<double> unknown_strips;   ///< mean number in a cycle
    std::optional<double> decided_percent;  ///< of the strips in view, see StripCounts
    std::array<std::uint64_t, all_beam_causes.size()> by_cause{};  ///< contacts of the drive, as BeamCause
    std::optional<double> fit_share;                               ///< mean share of the near floor that fits
    std::optional<double> vignetting;                              ///< as learnt at the end of the drive
};

ContactFigures contact_figures(const std::vector<FieldRow>& rows);

}  // namespace flownav::evaluation
