#pragma once
#include <optional>
#include <thread>

#include "flownav/io/bounded_queue.h"
#include "flownav/io/field_source.h"

namespace flownav::io {

struct Decoded {
    std::optional<ReplayEvent> event;  ///< empty at the end
    double progress = 0.0;             ///< progress of the reader after the event, 0..1
    double decode_s = 0.0;             ///< time to decode the event
};

/// Decodes the next event of `source`, which reads from `reader`. Throws as FieldSource::next() does.
Decoded decode_next(FieldSource& source, const RawlogReader& reader);

/// Decodes in a thread of its own, a few events ahead. The source and its reader must not be used until
/// next() has returned the end or thrown, or this object is destroyed.
class DecodeAhead {
  public:
    DecodeAhead(FieldSource& source, const RawlogReader& reader);
    ~DecodeAhead();
    DecodeAhead(const DecodeAhead&) = delete;
    DecodeAhead& operator=(const DecodeAhead&) = delete;

    /// Returns or throws the same as decode_next() in the same order. Must not be called after the end.
    Decoded next();

  private:
    void run(FieldSource& source, const RawlogReader& reader);

    BoundedQueue<Decoded> queue_;
    std::thread thread_;
};

}  // namespace flownav::io
