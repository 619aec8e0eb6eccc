#include "field_feed.h"
#include "flownav/io/rawlog_reader.h"

namespace flownav::io {
namespace {

class RawlogFeed : public FieldFeed {
  public:
    explicit RawlogFeed(const std::filesystem::path& file) : reader_(file) {}

    mrpt::obs::CObservation::Ptr next() override {
        auto observation = reader_.next();
        if (!observation && reader_.end().kind != ReadEnd::Kind::Clean) fail(reader_.end().message);
        return observation;
    }
    std::filesystem::path images_directory() const override { return reader_.images_directory(); }
    std::uint64_t objects() const override { return reader_.end().objects_read; }

  private:
    RawlogReader reader_;
};

}  // namespace

std::unique_ptr<FieldFeed> open_rawlog(const ProducerSettings& settings) {
    return std::make_unique<RawlogFeed>(settings.source);
}

}  // namespace flownav::io
