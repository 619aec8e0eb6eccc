#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace flownav::io {

/// Reads the uncompressed bytes of a plain or gz file. Unlike zlib's gz functions it delivers every byte
/// before the damage, and it distinguishes truncation, damage and a wrong checksum.
class InputBytes {
  public:
    enum class State {
        Good,       ///< all requested bytes were delivered
        End,        ///< end of the file; all checksums are right
        Truncated,  ///< the gz stream stops before its end
        Corrupt,    ///< the gz stream is damaged, its checksum is wrong, or the disk cannot be read
    };

    struct Inflater;

    /// Position in the bytes, for go_to().
    struct Mark {
        std::uint64_t file_offset = 0;             ///< offset of the first unused byte in the file
        std::shared_ptr<const Inflater> inflater;  ///< decoder state at the position; null for a plain file
    };

    /// Throws InputError: no such file, a folder, not readable, or empty.
    explicit InputBytes(const std::filesystem::path& file);
    ~InputBytes();
    InputBytes(const InputBytes&) = delete;
    InputBytes& operator=(const InputBytes&) = delete;

    /// Reads up to `count` bytes and returns their number; fewer only when state() is no longer Good.
    std::size_t read(std::uint8_t* target, std::size_t count);

    Mark mark() const;

    /// Moves to a position of a reader of the same file. Reads data appended to the file since.
    void go_to(const Mark& mark);

    State state() const { return state_; }
    const std::string& problem() const { return problem_; }  ///< reason of Truncated or Corrupt
    bool compressed() const { return inflater_ != nullptr; }

    /// Upper bound of the number of uncompressed bytes that follow.
    std::uint64_t upper_bound() const;

    /// Share of the file consumed, 0..1.
    double progress() const;

  private:
    struct Closer {
        void operator()(std::FILE* f) const { std::fclose(f); }
    };

    void refill();
    std::size_t copy_plain(std::uint8_t* target, std::size_t count);
    std::size_t inflate_some(std::uint8_t* target, std::size_t count);
    void start_next_member();
    void stop(State state, const std::string& problem);

    std::unique_ptr<std::FILE, Closer> file_;
    std::unique_ptr<Inflater> inflater_;
    std::uint64_t file_size_ = 0;
    std::uint64_t taken_ = 0;  ///< bytes of the file read into the buffer
    std::vector<std::uint8_t> buffer_;
    std::size_t at_ = 0;
    std::size_t filled_ = 0;
    bool file_over_ = false;
    State state_ = State::Good;
    std::string problem_;
};

}  // namespace flownav::io
