#include "object_reader.h"

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/rtti/CObject.h>
#include <mrpt/serialization/CArchive.h>

#include <sstream>

#include "object_header.h"

namespace flownav::io {
namespace {

using mrpt::serialization::CSerializable;

constexpr const char* cut_advice =
    "The recording was interrupted, or the file was not copied to its end: copy it again, or use what is "
    "there.";
constexpr const char* damage_advice = "Copy the file again from where it was recorded.";
constexpr const char* unknown_class_hint =
    "Nothing after it can be read: remove such objects with the program that wrote them; if no program does, "
    "the "
    "file is damaged.";

/// Largest plausible length, that of a picture. A larger one is reported as damage, a smaller one as
/// truncation.
constexpr std::uint32_t plausible_length_max = 1U << 26;

/// Thrown for a stored length that exceeds the rest of the file.
struct BogusLength {
    ObjectStream::ParseError parse_error;
    std::string text() const {
        return "the object asks for " + std::to_string(parse_error.value) + " elements at byte " +
               std::to_string(parse_error.byte_offset) + ", more than the file holds";
    }
};

/// Message of an MRPT exception without its call stack.
std::string short_reason(const std::string& what) {
    const std::string marker = "Message:";
    const auto at = what.rfind(marker);
    const auto begin = at == std::string::npos ? 0 : what.find_first_not_of(" \t", at + marker.size());
    return begin == std::string::npos ? "" : what.substr(begin, what.find('\n', begin) - begin);
}

/// Name of the unknown class of a nested object in MRPT's message; empty for other messages.
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

ObjectReader::ObjectReader(const std::filesystem::path& file) : file_(file), bytes_(file), stream_(bytes_) {
    require_rawlog();
}

void ObjectReader::require_rawlog() {
    const auto head = stream_.peek(object_header_bytes);
    if (head.empty() && bytes_.state() == InputBytes::State::End) {
        throw InputError(file_.string() + ": holds no object; the recording never got to its first one");
    }
    const ObjectHeader header = parse_object_header(head);
    if (header.kind == ObjectHeader::Kind::Malformed) {
        throw InputError(file_.string() + ": is not a rawlog: it does not begin with an MRPT object");
    }
    if (header.kind != ObjectHeader::Kind::Good) return;
    const auto* id = mrpt::rtti::findRegisteredClass(header.class_name);
    if (id == nullptr || belongs_into_rawlogs(*id)) return;
    throw InputError(file_.string() + ": is an MRPT file but not a rawlog: its first object is a " +
                     header.class_name);
}

CSerializable::Ptr ObjectReader::next() {
    CSerializable::Ptr object;
    while (!object && end_.kind == ReadEnd::Kind::NotYet) object = read_object();
    return object;
}

ObjectReader::Mark ObjectReader::mark() const {
    return {stream_.mark(end_.kind != ReadEnd::Kind::NotYet), end_.objects_read};
}

void ObjectReader::go_to(const Mark& mark) {
    stream_.go_to(mark.stream);
    end_ = ReadEnd{};
    end_.objects_read = mark.objects_read;
    end_.byte_offset = mark.stream.byte_offset;
}

CSerializable::Ptr ObjectReader::read_object() {
    if (!begin_object()) return nullptr;
    try {
        auto object = deserialize();
        ++end_.objects_read;
        return object;
    } catch (const BogusLength& length) {
        if (length.parse_error.value <= plausible_length_max) {
            finish(ReadEnd::Kind::Truncated, length.text(), cut_advice);
        } else {
            finish(ReadEnd::Kind::Corrupt, length.text(), damage_advice);
        }
    } catch (const std::exception& e) {
        finish_after(short_reason(e.what()));
    }
    return nullptr;
}

bool ObjectReader::begin_object() {
    stream_.begin_object();
    end_.byte_offset = stream_.object_offset();
    class_name_.clear();
    const auto head = stream_.peek(object_header_bytes);
    const ObjectHeader header = parse_object_header(head);
    if (header.kind != ObjectHeader::Kind::TooShort) class_name_ = header.class_name;
    if (head.empty() && bytes_.state() == InputBytes::State::End) {
        finish(ReadEnd::Kind::Clean, "", "");
    } else if (header.kind == ObjectHeader::Kind::TooShort) {
        finish_for_lack_of_bytes();
    } else if (header.kind == ObjectHeader::Kind::Malformed) {
        finish_after("no object begins here");
    } else if (class_name_ != "nullptr" && mrpt::rtti::findRegisteredClass(class_name_) == nullptr) {
        finish_unknown(class_name_);
    }
    return end_.kind == ReadEnd::Kind::NotYet;
}

CSerializable::Ptr ObjectReader::deserialize() {
    for (;;) {
        const Attempt attempt = try_to_deserialize();
        if (stream_.parse_errors().empty()) {
            if (attempt.failure) std::rethrow_exception(attempt.failure);
            return attempt.object;
        }
        const ObjectStream::ParseError parse_error = stream_.parse_errors().front();
        const std::uint64_t trace = stream_.trace();
        stream_.rewind(2);
        try_to_deserialize();
        if (stream_.trace() != trace) throw BogusLength{parse_error};
        stream_.settle_doubts();
        stream_.rewind(1);
    }
}

ObjectReader::Attempt ObjectReader::try_to_deserialize() {
    try {
        auto archive = mrpt::serialization::archiveFrom(stream_);
        return {archive.ReadObject(), nullptr};
    } catch (const std::exception&) {
        return {nullptr, std::current_exception()};
    }
}

void ObjectReader::finish(ReadEnd::Kind kind, const std::string& problem, const std::string& advice) {
    end_.kind = kind;
    if (kind == ReadEnd::Kind::Clean) return;
    std::ostringstream text;
    text << file_.string() << ": " << problem << ", at byte " << end_.byte_offset
         << (bytes_.compressed() ? " of the uncompressed data" : "") << ", object number "
         << end_.objects_read + 1;
    if (!class_name_.empty()) text << " (" << class_name_ << ")";
    text << ". The " << end_.objects_read << " objects before it were read. " << advice;
    end_.message = text.str();
}

void ObjectReader::finish_for_lack_of_bytes() {
    if (bytes_.state() == InputBytes::State::Corrupt) {
        return finish(ReadEnd::Kind::Corrupt, bytes_.problem(), damage_advice);
    }
    const bool gz_cut = bytes_.state() == InputBytes::State::Truncated;
    finish(ReadEnd::Kind::Truncated, gz_cut ? bytes_.problem() : "the file ends inside an object",
           cut_advice);
}

void ObjectReader::finish_after(const std::string& reason) {
    const std::string nested_class = unknown_class(reason);
    if (stream_.ran_dry()) {
        finish_for_lack_of_bytes();
    } else if (!nested_class.empty()) {
        finish_unknown(nested_class);
    } else {
        finish(ReadEnd::Kind::Corrupt, "the object is damaged (" + reason + ")", damage_advice);
    }
}

void ObjectReader::finish_unknown(const std::string& class_name) {
    finish(ReadEnd::Kind::UnknownClass, "the class " + class_name + " is not known to this program",
           unknown_class_hint);
}

}  // namespace flownav::io
