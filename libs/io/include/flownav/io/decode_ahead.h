#pragma once
#include <optional>
#include <thread>

#include "flownav/io/bounded_queue.h"
#include "flownav/io/field_source.h"

namespace flownav::io {

struct Decoded {
    std::optional<ReplayEvent> event;  ///< nothing: the end
    double progress = 0.0;             ///< of the reader, after it
    double decode_s = 0.0;             ///< time it took
};

/// The next event of `source`, which reads from `reader`. Throws what FieldSource::next() does.
Decoded decode_next(FieldSource& source, const RawlogReader& reader);

/// Decodes in a thread of its own, a few events ahead. Neither the source nor its reader may be touched
/// until the end, or an exception, has come, or this object is gone.
class DecodeAhead {
  public:
    DecodeAhead(FieldSource& source, const RawlogReader& reader);
    ~DecodeAhead();
    DecodeAhead(const DecodeAhead&) = delete;
    DecodeAhead& operator=(const DecodeAhead&) = delete;

    /// As decode_next(), with the same exceptions after the same events. Not to be called after the end.
    Decoded next();

  private:
    void run(FieldSource& source, const RawlogReader& reader);

    BoundedQueue<Decoded> queue_;
    std::thread thread_;
};

}  // namespace flownav::io
