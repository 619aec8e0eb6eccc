#include "background_reader.h"

#include <chrono>

namespace flownav::view {

namespace {

constexpr auto retry_after = std::chrono::milliseconds(20);

std::vector<MapPoint> points_of(const Frame& frame) {
    std::vector<MapPoint> points;
    points.reserve(frame.step.obstacles.size());
    for (const ObstaclePoint& point : frame.step.obstacles) {
        points.push_back(
            {frame.index, transform(frame.step.T_start_robot, point.position_m.head<2>()), point.moving});
    }
    return points;
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

BackgroundReader::BackgroundReader(const std::filesystem::path& file, const config::Config& config, Way way,
                                   bool follow)
    : runner_(file, config), follow_(follow) {
    news_.checkpoints.push_back(runner_.checkpoint());
    if (way == Way::Thread) thread_ = std::thread([this] { run(); });
}

BackgroundReader::~BackgroundReader() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        leave_ = true;
    }
    wake_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void BackgroundReader::run() {
    for (;;) {
        const bool more = work(1);
        std::unique_lock<std::mutex> lock(mutex_);
        if (leave_ || (!more && (!follow_ || !news_.failure.empty()))) return;
        if (!more) wake_.wait_for(lock, retry_after, [this] { return leave_; });
    }
}

bool BackgroundReader::work(std::size_t fields) {
    for (std::size_t i = 0; i < fields; ++i) {
        if (!advance()) return false;
    }
    return true;
}

bool BackgroundReader::advance() {
    try {
        const bool more = runner_.advance();
        if (more) {
            publish_field();
        } else {
            publish_end();
            if (follow_) runner_.retry();
        }
        return more;
    } catch (const std::exception& error) {
        const std::lock_guard<std::mutex> lock(mutex_);
        news_.failure = error.what();
        news_.complete = true;
        return false;
    }
}

void BackgroundReader::publish_field() {
    const bool due = runner_.next_index() % stride_ == 0;
    const auto checkpoint = due ? runner_.checkpoint() : nullptr;
    const std::vector<MapPoint> points = points_of(runner_.frame());
    const std::lock_guard<std::mutex> lock(mutex_);
    news_.rows.push_back(evaluation::row_of(runner_.frame().step));
    append(news_.points, points);
    append(news_.poses, runner_.poses());
    if (checkpoint) news_.checkpoints.push_back(checkpoint);
    news_.progress = runner_.progress();
    news_.complete = false;
}

void BackgroundReader::publish_end() {
    const std::lock_guard<std::mutex> lock(mutex_);
    append(news_.poses, runner_.poses());
    news_.counts = runner_.counts();
    news_.complete = true;
    news_.end = runner_.end();
    news_.stop_reason = runner_.stop_reason();
    news_.progress = runner_.progress();
}

BackgroundNews BackgroundReader::take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    BackgroundNews news = std::move(news_);
    news_ = {};
    news_.counts = news.counts;
    news_.complete = news.complete;
    news_.end = news.end;
    news_.stop_reason = news.stop_reason;
    news_.progress = news.progress;
    news_.failure = news.failure;
    return news;
}

}  // namespace flownav::view
