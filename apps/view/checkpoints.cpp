#include "checkpoints.h"

#include <algorithm>

namespace flownav::view {

void Checkpoints::add(std::shared_ptr<const Checkpoint> checkpoint) {
    if (checkpoint->next_index % stride_ != 0) return;
    bytes_ += checkpoint->bytes();
    kept_.push_back(std::move(checkpoint));
    while (bytes_ > bytes_max_ && kept_.size() > 2) thin();
}

void Checkpoints::thin() {
    stride_ *= 2;
    const auto superfluous = [this](const auto& checkpoint) { return checkpoint->next_index % stride_ != 0; };
    kept_.erase(std::remove_if(kept_.begin(), kept_.end(), superfluous), kept_.end());
    bytes_ = 0;
    for (const auto& checkpoint : kept_) bytes_ += checkpoint->bytes();
}

std::shared_ptr<const Checkpoint> Checkpoints::before(std::size_t index) const {
    const auto after =
        std::upper_bound(kept_.begin(), kept_.end(), index,
                         [](std::size_t i, const auto& checkpoint) { return i < checkpoint->next_index; });
    return after == kept_.begin() ? nullptr : *std::prev(after);
}

}  // namespace flownav::view
