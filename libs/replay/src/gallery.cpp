#include "flownav/replay/annotated_field.h"

namespace flownav {

void Gallery::offer(const Field& field, const pipeline::Step& step) {
    if (offered_++ % stride_ != 0) return;
    kept_.push_back({field, step});
    if (kept_.size() < most_kept) return;
    // Every second one goes, and from now on only every second one comes.
    std::vector<Picture> thinned;
    for (std::size_t i = 0; i < kept_.size(); i += 2) thinned.push_back(std::move(kept_[i]));
    kept_ = std::move(thinned);
    stride_ *= 2;
}

std::vector<const Gallery::Picture*> Gallery::spread(std::size_t count) const {
    std::vector<const Picture*> chosen;
    if (kept_.empty() || count == 0) return chosen;
    if (count > kept_.size()) count = kept_.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = count == 1 ? 0 : (i * (kept_.size() - 1) + (count - 1) / 2) / (count - 1);
        chosen.push_back(&kept_[at]);
    }
    return chosen;
}

}  // namespace flownav
