#pragma once
#include <mrpt/serialization/CSerializable.h>

#include <exception>
#include <filesystem>
#include <string>

#include "flownav/io/rawlog_reader.h"
#include "input_bytes.h"
#include "object_stream.h"

namespace flownav::io {

/// Reads the top-level objects of a rawlog in order, and reports kind and place of the end.
class ObjectReader {
  public:
    /// Position between two objects, for go_to().
    struct Mark {
        ObjectStream::Mark stream;
        std::uint64_t objects_read = 0;
    };

    /// Throws InputError when the file cannot be opened, or does not begin with an object of a rawlog.
    explicit ObjectReader(const std::filesystem::path& file);

    /// Next object; null at the end, when end() holds its kind.
    mrpt::serialization::CSerializable::Ptr next();

    /// Position of the next object; at the end, position of the object that could not be read.
    Mark mark() const;
    void go_to(const Mark& mark);

    const ReadEnd& end() const { return end_; }
    double progress() const { return bytes_.progress(); }

  private:
    struct Attempt {
        mrpt::serialization::CSerializable::Ptr object;
        std::exception_ptr failure;
    };

    void require_rawlog();
    mrpt::serialization::CSerializable::Ptr read_object();
    bool begin_object();
    mrpt::serialization::CSerializable::Ptr deserialize();
    Attempt try_to_deserialize();
    void finish(ReadEnd::Kind kind, const std::string& problem, const std::string& advice);
    void finish_for_lack_of_bytes();
    void finish_after(const std::string& reason);
    void finish_unknown(const std::string& class_name);

    std::filesystem::path file_;
    InputBytes bytes_;
    ObjectStream stream_;
    ReadEnd end_;
    std::string class_name_;  ///< class of the object being read
};

}  // namespace flownav::io
