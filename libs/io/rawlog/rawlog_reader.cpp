#include "flownav/io/rawlog_reader.h"

#include <mrpt/maps/registerAllClasses.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/registerAllClasses.h>

#include <deque>

#include "action_odometry.h"
#include "flownav/io/flow_field_observation.h"
#include "object_reader.h"

namespace flownav::io {

namespace {

/// Folder of external images by MRPT's convention. CRawlog::detectImagesDirectory() of MRPT 2.5.8 loses the
/// separator before the name.
std::filesystem::path find_images_directory(const std::filesystem::path& file) {
    for (const char* ending : {"_Images", "_images", "_IMAGES"}) {
        auto folder = file.parent_path() / (file.stem().string() + ending);
        if (std::filesystem::is_directory(folder)) return folder;
    }
    return file.parent_path() / "Images";
}

}  // namespace

namespace {

/// Observations not yet returned, and the state that later objects depend on.
struct Unpacked {
    std::deque<mrpt::obs::CObservation::Ptr> waiting;
    ActionOdometry actions;
    bool odometry_observed = false;
};

}  // namespace

struct RawlogReader::Mark {
    ObjectReader::Mark objects;
    Unpacked unpacked;
};

struct RawlogReader::Impl : Unpacked {
    explicit Impl(const std::filesystem::path& file) : objects(file), images(find_images_directory(file)) {}

    void unpack(const mrpt::serialization::CSerializable::Ptr& object);
    void unpack(const mrpt::obs::CSensoryFrame& frame);

    ObjectReader objects;
    std::filesystem::path images;
};

void RawlogReader::Impl::unpack(const mrpt::serialization::CSerializable::Ptr& object) {
    if (auto observation = std::dynamic_pointer_cast<mrpt::obs::CObservation>(object)) {
        odometry_observed = odometry_observed || IS_CLASS(*observation, mrpt::obs::CObservationOdometry);
        waiting.push_back(std::move(observation));
    } else if (const auto* frame = dynamic_cast<const mrpt::obs::CSensoryFrame*>(object.get())) {
        unpack(*frame);
    } else if (const auto* collection = dynamic_cast<const mrpt::obs::CActionCollection*>(object.get())) {
        actions.add(*collection);
    }
}

void RawlogReader::Impl::unpack(const mrpt::obs::CSensoryFrame& frame) {
    const auto reading = actions.take(frame);
    if (reading && !odometry_observed) waiting.push_back(reading);
    for (const auto& observation : frame) {
        if (observation) waiting.push_back(observation);
    }
}

RawlogReader::RawlogReader(const std::filesystem::path& file) {
    mrpt::obs::registerAllClasses_mrpt_obs();
    mrpt::maps::registerAllClasses_mrpt_maps();
    mrpt::rtti::registerClass(CLASS_ID(CObservationFlowField));
    impl_ = std::make_unique<Impl>(file);
}

RawlogReader::~RawlogReader() = default;

mrpt::obs::CObservation::Ptr RawlogReader::next() {
    while (impl_->waiting.empty()) {
        const auto object = impl_->objects.next();
        if (!object) return nullptr;
        impl_->unpack(object);
    }
    auto observation = impl_->waiting.front();
    impl_->waiting.pop_front();
    return observation;
}

const ReadEnd& RawlogReader::end() const {
    return impl_->objects.end();
}

std::shared_ptr<const RawlogReader::Mark> RawlogReader::mark() const {
    return std::make_shared<const Mark>(Mark{impl_->objects.mark(), *impl_});
}

void RawlogReader::go_to(const Mark& mark) {
    impl_->objects.go_to(mark.objects);
    static_cast<Unpacked&>(*impl_) = mark.unpacked;
}

double RawlogReader::progress() const {
    return impl_->objects.progress();
}

const std::filesystem::path& RawlogReader::images_directory() const {
    return impl_->images;
}

}  // namespace flownav::io
