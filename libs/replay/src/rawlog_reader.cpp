#include "flownav/replay/rawlog_reader.h"

#include <mrpt/maps/registerAllClasses.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/registerAllClasses.h>
#include <mrpt/rtti/CObject.h>
#include <mrpt/serialization/CArchive.h>

#include <deque>
#include <sstream>

#include "action_odometry.h"
#include "input_bytes.h"
#include "object_header.h"
#include "object_stream.h"

namespace flownav {
namespace {

using mrpt::serialization::CSerializable;

/// The sentence of an MRPT exception, without its call stack.
std::string short_reason(const std::string& what) {
    const std::string marker = "Message:";
    const auto at = what.rfind(marker);
    const auto begin = at == std::string::npos ? 0 : what.find_first_not_of(" \t", at + marker.size());
    return begin == std::string::npos ? "" : what.substr(begin, what.find('\n', begin) - begin);
}

/// The class MRPT names when it does not know a nested object; empty when that is not what happened.
std::string unknown_class(const std::string& reason) {
    if (reason.find("not registered") == std::string::npos) return "";
    const auto open = reason.find('\'');
    const auto close = reason.find('\'', open + 1);
    if (open == std::string::npos || close == std::string::npos) return "";
    const std::string name = reason.substr(open + 1, close - open - 1);
    return is_class_name(name) ? name : "";
}

bool belongs_into_rawlogs(const mrpt::rtti::TRuntimeClassId& id) {
    return id.derivedFrom(CLASS_ID(mrpt::obs::CObservation)) ||
           id.derivedFrom(CLASS_ID(mrpt::obs::CSensoryFrame)) ||
           id.derivedFrom(CLASS_ID(mrpt::obs::CActionCollection));
}

}  // namespace

struct RawlogReader::Impl {
    explicit Impl(const std::filesystem::path& path)
        : file(path),
          images(mrpt::obs::CRawlog::detectImagesDirectory(path.string())),
          bytes(path),
          stream(bytes) {}

    void require_rawlog();
    void read_object();
    CSerializable::Ptr deserialize();
    void unpack(const CSerializable::Ptr& object);
    void unpack(const mrpt::obs::CSensoryFrame& frame);
    void finish(ReadEnd::Kind kind, const std::string& problem, const std::string& advice);
    void finish_for_lack_of_bytes();
    void finish_after(const std::string& reason);

    std::filesystem::path file;
    std::filesystem::path images;
    InputBytes bytes;
    ObjectStream stream;
    ReadEnd end;
    std::string class_name;  ///< of the object being read
    std::deque<mrpt::obs::CObservation::Ptr> waiting;
    ActionOdometry actions;
    bool odometry_observed = false;
};

void RawlogReader::Impl::require_rawlog() {
    const ObjectHeader header = parse_object_header(stream.peek(object_header_bytes));
    if (header.kind == ObjectHeader::Kind::Malformed) {
        throw InputError(file.string() + ": is not a rawlog: it does not begin with an MRPT object");
    }
    const auto* id = header.kind == ObjectHeader::Kind::Good
                         ? mrpt::rtti::findRegisteredClass(header.class_name)
                         : nullptr;
    if (id != nullptr && !belongs_into_rawlogs(*id)) {
        throw InputError(file.string() + ": is an MRPT file but not a rawlog: its first object is a " +
                         header.class_name);
    }
}

void RawlogReader::Impl::read_object() {
    stream.begin_object();
    end.byte_offset = stream.object_offset();
    class_name.clear();
    const auto head = stream.peek(object_header_bytes);
    if (head.empty() && bytes.state() == InputBytes::State::End) return finish(ReadEnd::Kind::Clean, "", "");
    const ObjectHeader header = parse_object_header(head);
    class_name = header.class_name;
    if (header.kind == ObjectHeader::Kind::TooShort) return finish_for_lack_of_bytes();
    if (header.kind == ObjectHeader::Kind::Malformed) return finish_after("no object begins here");
    if (class_name != "nullptr" && mrpt::rtti::findRegisteredClass(class_name) == nullptr) {
        return finish_after("'" + class_name + "' is not registered");
    }
    try {
        const CSerializable::Ptr object = deserialize();
        ++end.objects_read;
        if (object) unpack(object);
    } catch (const std::exception& e) {
        finish_after(short_reason(e.what()));
    }
}

CSerializable::Ptr RawlogReader::Impl::deserialize() {
    auto archive = mrpt::serialization::archiveFrom(stream);
    CSerializable::Ptr object = archive.ReadObject();
    if (stream.doubt()) {
        stream.rewind();
        object = archive.ReadObject();
    }
    return object;
}

void RawlogReader::Impl::unpack(const CSerializable::Ptr& object) {
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

void RawlogReader::Impl::finish(ReadEnd::Kind kind, const std::string& problem, const std::string& advice) {
    end.kind = kind;
    if (kind == ReadEnd::Kind::Clean) return;
    std::ostringstream text;
    text << file.string() << ": " << problem << ", at byte " << end.byte_offset
         << (bytes.compressed() ? " of the uncompressed data" : "") << ", object number "
         << end.objects_read + 1;
    if (!class_name.empty()) text << " (" << class_name << ")";
    text << ". The " << end.objects_read << " objects before it were read. " << advice;
    end.message = text.str();
}

void RawlogReader::Impl::finish_for_lack_of_bytes() {
    if (bytes.state() == InputBytes::State::Corrupt) {
        return finish(ReadEnd::Kind::Corrupt, bytes.problem(),
                      "Copy the file again from where it was recorded.");
    }
    const std::string where =
        stream.ran_dry() || !class_name.empty() ? "the file ends inside an object" : "the file ends early";
    const std::string problem = bytes.state() == InputBytes::State::Truncated ? bytes.problem() : where;
    finish(ReadEnd::Kind::Truncated, problem,
           "The recording was interrupted, or the file was not copied to its end: copy it again, or use the "
           "part "
           "that is there.");
}

void RawlogReader::Impl::finish_after(const std::string& reason) {
    if (stream.ran_dry()) return finish_for_lack_of_bytes();
    const std::string copy_again = "Copy the file again from where it was recorded.";
    const std::string stranger = unknown_class(reason);
    if (!stranger.empty()) {
        return finish(
            ReadEnd::Kind::UnknownClass, "the class " + stranger + " is not known to this program",
            "Nothing after it can be read: remove such objects with the program that wrote them; if no "
            "program writes them, the file is damaged.");
    }
    if (const auto& doubt = stream.doubt()) {
        return finish(ReadEnd::Kind::Corrupt,
                      "the object is damaged (it asks for " + std::to_string(doubt->value) +
                          " elements at byte " + std::to_string(doubt->byte_offset) +
                          ", more than the file holds)",
                      copy_again);
    }
    finish(ReadEnd::Kind::Corrupt, "the object is damaged (" + reason + ")", copy_again);
}

RawlogReader::RawlogReader(const std::filesystem::path& file) {
    mrpt::obs::registerAllClasses_mrpt_obs();
    mrpt::maps::registerAllClasses_mrpt_maps();
    impl_ = std::make_unique<Impl>(file);
    impl_->require_rawlog();
}

RawlogReader::~RawlogReader() = default;

mrpt::obs::CObservation::Ptr RawlogReader::next() {
    while (impl_->waiting.empty()) {
        if (impl_->end.kind != ReadEnd::Kind::NotYet) return nullptr;
        impl_->read_object();
    }
    auto observation = impl_->waiting.front();
    impl_->waiting.pop_front();
    return observation;
}

const ReadEnd& RawlogReader::end() const {
    return impl_->end;
}

double RawlogReader::progress() const {
    return impl_->bytes.progress();
}

const std::filesystem::path& RawlogReader::images_directory() const {
    return impl_->images;
}

}  // namespace flownav
