#include "flownav/io/bounded_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <stdexcept>
#include <thread>

namespace flownav::io {
namespace {

TEST(BoundedQueue, HandsOverEverythingInOrderThenEnds) {
    BoundedQueue<std::unique_ptr<int>> queue(2);  // holds types that cannot be copied
    std::thread producer([&queue] {
        for (int i = 0; i < 1000; ++i) queue.push(std::make_unique<int>(i));
        queue.close();
    });
    for (int i = 0; i < 1000; ++i) {
        const auto thing = queue.pop();
        ASSERT_TRUE(thing && *thing);
        EXPECT_EQ(**thing, i);
    }
    EXPECT_FALSE(queue.pop());
    producer.join();
}

TEST(BoundedQueue, NeverHoldsMoreThanItsCapacity) {
    BoundedQueue<int> queue(3);
    std::atomic<int> pushed{0};
    std::atomic<int> popped{0};
    std::thread producer([&] {
        for (int i = 0; i < 1000; ++i) {
            queue.push(i);
            // One more element may have been popped and not yet counted.
            EXPECT_LE(++pushed - popped, 3 + 1);
        }
        queue.close();
    });
    while (queue.pop()) ++popped;
    producer.join();
    EXPECT_EQ(popped, 1000);
}

TEST(BoundedQueue, AnExceptionOfTheProducerComesAfterWhatItHadPushed) {
    BoundedQueue<int> queue(4);
    queue.push(7);
    queue.close(std::make_exception_ptr(std::runtime_error("damaged")));
    EXPECT_EQ(queue.pop(), 7);
    try {
        queue.pop();
        FAIL() << "no exception";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "damaged");
    }
}

TEST(BoundedQueue, AConsumerThatStopsFreesAWaitingProducer) {
    BoundedQueue<int> queue(1);
    std::thread producer([&queue] {
        while (queue.push(1)) {
        }
    });
    EXPECT_EQ(queue.pop(), 1);
    queue.stop();
    producer.join();
    EXPECT_FALSE(queue.push(2));
}

}  // namespace
}  // namespace flownav::io
