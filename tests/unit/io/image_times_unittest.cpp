#include <gtest/gtest.h>

#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "flownav/io/errors.h"
#include "flownav/io/image_folder.h"
#include "import_samples.h"
#include "rawlog_files.h"

namespace flownav::io {
namespace {

namespace fs = std::filesystem;
using namespace flownav::testing;

/// Writes pictures with these names; their offsets count from 0.
fs::path folder_with(const std::vector<std::string>& names) {
    const fs::path folder = test_folder() / "images";
    fs::remove_all(folder);
    int offset = 0;
    for (const std::string& name : names) write_sample_picture(folder / name, offset++);
    return folder;
}

const std::vector<std::string> three = {"000000.png", "000001.png", "000002.png"};

/// What an import of three pictures with a file of times gives.
struct Imported {
    std::vector<double> times_s;
    std::vector<std::string> notes, problems;
    std::string refusal;
};

Imported import(const fs::path& folder, const FrameTimes& times) {
    Imported result;
    try {
        ImageFolder sequence(folder, sample_camera(), times);
        result.times_s = times_of(sequence);
        result.notes = sequence.notes();
        result.problems = sequence.problems();
    } catch (const InputError& error) {
        result.refusal = error.what();
    }
    return result;
}

Imported import_with(const std::vector<std::string>& names, const std::string& list,
                     std::optional<TimeUnit> unit = std::nullopt) {
    const fs::path folder = folder_with(names);
    const fs::path file = folder.parent_path() / "list.txt";
    write_bytes(file, list);
    FrameTimes times;
    times.file = file;
    times.unit = unit;
    return import(folder, times);
}

Imported import_names(const std::vector<std::string>& names, std::optional<double> rate_hz = std::nullopt,
                      std::optional<TimeUnit> unit = std::nullopt) {
    FrameTimes times;
    times.rate_hz = rate_hz;
    times.unit = unit;
    return import(folder_with(names), times);
}

TEST(ImageTimes, NanosecondsAndMillisecondsSince1970AreRecognisedAndTold) {
    const std::vector<double> expected = {1403636579.763555584, 1403636579.803555584, 1403636579.843555584};
    const auto ns = import_with(three, "1403636579763555584\n1403636579803555584\n1403636579843555584\n");
    expect_times(ns.times_s, expected);
    EXPECT_TRUE(some_says(ns.notes, {"nanoseconds", "0.04 s apart", "--times-unit"}));
    const auto ms = import_with(three, "1403636579763\n1403636579803\n1403636579843\n");
    expect_times(ms.times_s, {1403636579.763, 1403636579.803, 1403636579.843});
    EXPECT_TRUE(some_says(ms.notes, {"milliseconds"}));
    const auto us = import_with(three, "1403636579763555\n1403636579803555\n1403636579843555\n");
    expect_times(us.times_s, {1403636579.763555, 1403636579.803555, 1403636579.843555});
    EXPECT_TRUE(some_says(us.notes, {"microseconds"}));
}

TEST(ImageTimes, SecondsNeedNoWord) {
    const auto seconds = import_with(three, "1403636579.76\n1403636579.80\n1403636579.84\n");
    expect_times(seconds.times_s, {1403636579.76, 1403636579.80, 1403636579.84});
    EXPECT_TRUE(seconds.notes.empty());
    EXPECT_TRUE(import_with(three, "0\n0.04\n0.08\n").notes.empty());
}

TEST(ImageTimes, RelativeTimesInOtherUnitsAreRecognisedByTheDistanceOfTheImages) {
    for (const auto& [list, word] : {std::pair{"0\n40\n80\n", "milliseconds"},
                                     {"0\n40000\n80000\n", "microseconds"},
                                     {"0\n40000000\n80000000\n", "nanoseconds"}}) {
        const auto result = import_with(three, list);
        expect_times(result.times_s, {0, 0.04, 0.08});
        EXPECT_TRUE(some_says(result.notes, {word}));
    }
}

TEST(ImageTimes, TimesOfNoKnownUnitAreRefusedWithTheOption) {
    for (const char* list : {"0\n1\n2\n", "0\n5\n10\n", "0\n0.00001\n0.00002\n", "0\n3000\n6000\n"}) {
        expect_parts(import_with(three, list).refusal, {"list.txt", "--times-unit"});
    }
    expect_times(import_with(three, "0\n5\n10\n", TimeUnit::Milliseconds).times_s, {0, 0.005, 0.01});
    expect_times(import_with(three, "0\n5\n10\n", TimeUnit::Seconds).times_s, {0, 5, 10});
}

TEST(ImageTimes, LargeNumbersThatAreTimesInTwoUnitsAreRefused) {
    expect_parts(import_with(three, "1403636579\n1403636599\n1403636619\n").refusal,
                 {"20 s apart as seconds since 1970", "0.02 s apart as milliseconds", "--times-unit"});
    expect_times(import_with(three, "1403636579\n1403676579\n1403716579\n").times_s,
                 {1403.636579, 1403.676579, 1403.716579});
}

TEST(ImageTimes, TheHeaderNamesTheUnit) {
    expect_times(import_with(three, "time_ms\n0\n5\n10\n").times_s, {0, 0.005, 0.01});
    expect_times(import_with(three, "stamp [us]\n0\n5000\n10000\n").times_s, {0, 0.005, 0.01});
    const auto wrong = import_with(three, "timestamp_s\n1403636579763\n1403636579803\n1403636579843\n");
    expect_times(wrong.times_s, {1403636579.763, 1403636579.803, 1403636579.843});
    EXPECT_TRUE(some_says(wrong.notes, {"header says seconds", "milliseconds since 1970"}));
    expect_parts(import_with(three, "timestamp_s\n0\n40\n80\n").refusal,
                 {"header says seconds", "40 s apart"});
}

TEST(ImageTimes, WholeSecondsThatImagesShareAreRefused) {
    std::vector<std::string> names;
    std::string list;
    for (int i = 0; i < 12; ++i) {
        names.push_back(std::to_string(i) + ".png");
        list += std::to_string(1403636579 + i / 4) + "\n";
    }
    expect_parts(import_with(names, list).refusal, {"9 of 12", "whole numbers", "--rate"});
}

TEST(ImageTimes, OneImageASecondIsToldWithTheKeyOfTheReplay) {
    const auto result = import_with(three, "1403636579\n1403636580\n1403636581\n");
    expect_times(result.times_s, {1403636579, 1403636580, 1403636581});
    EXPECT_TRUE(some_says(result.notes, {"1 s apart", "motion.gap_max_s"}));
}

TEST(ImageTimes, NegativeAndFarTimesAreRefused) {
    expect_parts(import_with(three, "-0.04\n0\n0.04\n").refusal, {"line 1", "negative"});
    expect_parts(import_with(three, "5e9\n5000000000.04\n5000000000.08\n", TimeUnit::Seconds).refusal,
                 {"line 1", "2100"});
    expect_parts(import_with(three, "0\n0.04\n1e15\n").refusal, {"line 3", "2100"});
    expect_parts(import_with(three, "0\nnan\n1\n").refusal, {"line 2", "no time"});
}

TEST(ImageTimes, ALongPauseIsTold) {
    const auto result = import_with(three, "0\n0.04\n86400.08\n");
    expect_times(result.times_s, {0, 0.04, 86400.08});
    EXPECT_TRUE(some_says(result.notes, {"000002.png", "86400 s after"}));
    expect_parts(import_with({"0.png", "1.png", "2.png", "3.png"}, "0\n0.04\n86400.08\n0.12\n").refusal,
                 {"line 4", "not later"});
}

TEST(ImageTimes, DatesAreTimes) {
    const std::vector<double> expected = {1317042145.0, 1317042145.04, 1317042145.08};
    for (const char* list :
         {"2011-09-26 13:02:25.00\n2011-09-26 13:02:25.04\n2011-09-26 13:02:25.08\n",
          "2011-09-26T13:02:25.00Z\n2011-09-26T13:02:25.04Z\n2011-09-26T13:02:25.08Z\n",
          "2011-09-26T15:02:25.00+02:00\n2011-09-26T15:02:25.04+02:00\n2011-09-26T15:02:25.08+02:00\n",
          "time,file\n2011/09/26 13:02:25.00,000000.png\n2011/09/26 13:02:25.04,000001.png\n"
          "2011/09/26 13:02:25.08,000002.png\n"})
        expect_times(import_with(three, list).times_s, expected);
}

TEST(ImageTimes, WindowsLineEndsAndAByteOrderMarkAreSkipped) {
    const auto result = import_with(three, "\xEF\xBB\xBFtimestamp_s\r\n0\r\n0.04\r\n\r\n0.08\r\n");
    expect_times(result.times_s, {0, 0.04, 0.08});
    expect_parts(import_with(three, "\xFF\xFEx").refusal, {"UTF-16"});
}

TEST(ImageTimes, DecimalCommasAreExplained) {
    expect_parts(import_with(three, "file;timestamp_s\n000000.png;0,00\n000001.png;0,04\n").refusal,
                 {"line 2", "decimal point"});
    expect_parts(import_with(three, "0,00\n0,04\n0,08\n").refusal, {"decimal"});
}

TEST(ImageTimes, AColumnOfNamesMatchesByNameWhereverItIs) {
    const char* swapped = "000002.png,0.08\n000000.png,0.00\n000001.png,0.04\n";
    for (const std::string& list :
         {std::string("file,timestamp_s\n") + swapped, std::string(swapped),
          std::string("timestamp_s,exposure,filename\n0.04,7,rgb/000001.png\n0.08,7,rgb/000002.png\n"
                      "0.00,7,rgb/000000.png\n"),
          std::string("# color images\n# timestamp filename\n0.00 rgb/000000.png\n0.04 rgb/000001.png\n"
                      "0.08 rgb/000002.png\n"),
          std::string("000000 0.00 12.5\n000001 0.04 12.5\n000002 0.08 12.5\n"),
          std::string("\"time_ms\",\"image\"\n\"0\",\"000000.png\"\n\"40\",\"000001.png\"\n\"80\",\"000002."
                      "png\"\n")}) {
        const auto result = import_with(three, list);
        expect_times(result.times_s, {0, 0.04, 0.08});
        EXPECT_TRUE(result.problems.empty()) << list;
    }
}

TEST(ImageTimes, EurocsListMatchesByName) {
    const std::string a = "1403636579763555584";
    const std::string b = "1403636579803555584";
    const auto result = import_with({a + ".png", b + ".png"}, "#timestamp [ns],filename\r\n" + a + "," + a +
                                                                  ".png\r\n" + b + "," + b + ".png\r\n");
    expect_times(result.times_s, {1403636579.763555584, 1403636579.803555584});
    EXPECT_TRUE(result.problems.empty());
}

TEST(ImageTimes, ImagesAndRowsWithoutPartnersAreTold) {
    const auto result =
        import_with(three, "file,timestamp_s\n000000.png,0\n000002.png,0.08\n000007.png,0.28\n");
    expect_times(result.times_s, {0, 0.08});
    EXPECT_TRUE(some_says(result.problems, {"000001.png", "no time for it"}));
    EXPECT_TRUE(some_says(result.problems, {"1 of its 3 times have no image", "line 4"}));
    expect_parts(import_with(three, "file,timestamp_s\na.png,0\nb.png,0.04\nc.png,0.08\n").refusal,
                 {"names none of the images", "000000.png"});
    expect_parts(import_with(three, "file,timestamp_s\n000000.png,0\n000000.png,0.04\n").refusal,
                 {"line 3", "second time"});
}

TEST(ImageTimes, TwoImagesWithOneTimeAreNotBothTaken) {
    const auto result =
        import_with(three, "file,timestamp_s\n000000.png,0\n000001.png,0.04\n000002.png,0.04\n");
    expect_times(result.times_s, {0, 0.04});
    EXPECT_TRUE(some_says(result.problems, {"000002.png", "same time as 000001.png"}));
}

const std::vector<std::string> gap = {"000000.png", "000001.png", "000002.png",
                                      "000003.png", "000008.png", "000009.png"};
constexpr auto ten_times = "0.00\n0.04\n0.08\n0.12\n0.16\n0.20\n0.24\n0.28\n0.32\n0.36\n";

TEST(ImageTimes, MoreTimesThanImagesAreMatchedByTheNumbersOfTheImages) {
    const auto result = import_with(gap, ten_times);
    expect_times(result.times_s, {0, 0.04, 0.08, 0.12, 0.32, 0.36});
    EXPECT_TRUE(some_says(result.notes, {"numbers in their names"}));
    EXPECT_TRUE(some_says(result.problems, {"4 of its 10 times have no image", "line 5"}));
}

TEST(ImageTimes, NumbersMayCountFromOne) {
    const auto result = import_with({"img1.png", "img2.png", "img4.png"}, "0\n0.04\n0.09\n0.12\n");
    expect_times(result.times_s, {0, 0.04, 0.12});
}

TEST(ImageTimes, AColumnOfNumbersMatchesByNumber) {
    const auto result =
        import_with({"img3.png", "img5.png", "img6.png"}, "index,time\n3,0.12\n4,0.16\n5,0.20\n6,0.24\n");
    expect_times(result.times_s, {0.12, 0.20, 0.24});
    EXPECT_TRUE(some_says(result.problems, {"1 of its 4 times have no image"}));
}

TEST(ImageTimes, TimesThatCannotBeMatchedAreRefused) {
    expect_parts(import_with({"a.png", "b.png"}, "0\n0.04\n0.08\n").refusal,
                 {"3 times for 2 images", "--rate"});
    expect_parts(import_with(three, "0\n0.04\n").refusal, {"2 times for 3 images"});
    expect_parts(import_with({"img3.png", "img5.png", "img6.png"}, "0\n0.04\n0.08\n0.12\n").refusal,
                 {"4 times for 3 images", "numbered 3 to 6"});
    expect_parts(import_with({"img2.png", "img3.png"}, "0\n0.04\n0.10\n0.12\n").refusal,
                 {"from 0 or from 1"});
    expect_parts(import_with(gap, "0\n0.04\n0.08\n0.12\n0.16\n0.20\n").refusal, {"gaps", "times have none"});
}

TEST(ImageTimes, AsManyTimesAsImagesBelongToTheirOrderWhenTheyPauseWhereTheNumbersDo) {
    expect_times(import_with(gap, "0\n0.04\n0.08\n0.12\n0.32\n0.36\n").times_s,
                 {0, 0.04, 0.08, 0.12, 0.32, 0.36});
    expect_times(import_with({"a.png", "b.png", "c.png"}, "0\n0.04\n0.08\n").times_s, {0, 0.04, 0.08});
}

TEST(ImageTimes, NamesThatAreTimesAreTheTimes) {
    const std::vector<std::vector<std::string>> series = {
        {"1403636579763555584.png", "1403636579803555584.png", "1403636579963555584.png"},
        {"1403636579763555.png", "1403636579803555.png", "1403636579963555.png"},
        {"left-1403636579763.png", "left-1403636579803.png", "left-1403636579963.png"},
        {"1403636579.763555.png", "1403636579.803555.png", "1403636579.963555.png"},
        {"cam0_1403636579_763555584.jpg", "cam0_1403636579_803555584.jpg", "cam0_1403636579_963555584.jpg"},
        {"frame0001_1403636579763.png", "frame0002_1403636579803.png", "frame0003_1403636579963.png"},
        {"20140624_190259_763.png", "20140624_190259_803.png", "20140624_190259_963.png"},
        {"2014-06-24T19-02-59.763.png", "2014-06-24T19-02-59.803.png", "2014-06-24T19-02-59.963.png"},
    };
    for (const auto& names : series) {
        const auto result = import_names(names);
        ASSERT_EQ(result.times_s.size(), 3U) << names[0] << result.refusal;
        EXPECT_NEAR(result.times_s[1] - result.times_s[0], 0.04, 1e-5) << names[0];
        EXPECT_NEAR(result.times_s[2] - result.times_s[1], 0.16, 1e-5) << names[0];
        EXPECT_GT(result.times_s[0], 1.4e9);
        EXPECT_TRUE(some_says(result.notes, {"the names of the images are times"}));
    }
}

TEST(ImageTimes, FractionsWithoutLeadingZerosAreNanoseconds) {
    const auto result = import_names({"1403636579_963555584.png", "1403636580_3555584.png"});
    expect_times(result.times_s, {1403636579.963555584, 1403636580.003555584});
}

TEST(ImageTimes, NamesThatAreTimesMatchTheTimesOfAList) {
    const std::vector<std::string> names = {"1403636579763555584.png", "1403636579843555584.png"};
    const auto result = import_with(names, "1403636579763555584\n1403636579803555584\n1403636579843555584\n");
    expect_times(result.times_s, {1403636579.763555584, 1403636579.843555584});
    EXPECT_FALSE(result.problems.empty());
    expect_parts(import_with(names, "0\n0.04\n").refusal, {"another time than the name"});
}

TEST(ImageTimes, NumbersOfImagesCountAtARate) {
    const auto result = import_names(gap, 25.0);
    expect_times(result.times_s, {0, 0.04, 0.08, 0.12, 0.32, 0.36});
    EXPECT_TRUE(some_says(result.problems, {"4 of 10 numbers", "no image"}));
    const auto fifth = import_names({"0.png", "5.png", "10.png"}, 10.0);
    expect_times(fifth.times_s, {0, 0.1, 0.2});
    EXPECT_TRUE(some_says(fifth.notes, {"rise by 5"}));
    EXPECT_TRUE(fifth.problems.empty());
}

TEST(ImageTimes, TheNumberThatRisesCountsTheImages) {
    expect_times(
        import_names({"image7_exposure80.png", "image8_exposure90.png", "image11_exposure80.png"}, 10.0)
            .times_s,
        {0, 0.1, 0.4});
}

TEST(ImageTimes, ARateThatIsAssumedIsTold) {
    const auto assumed = import_names(three);
    expect_times(assumed.times_s, {0, 0.04, 0.08});
    EXPECT_TRUE(some_says(assumed.notes, {"25 images a second", "assumed", "--rate"}));
    EXPECT_TRUE(import_names(three, 25.0).notes.empty());
}

TEST(ImageTimes, NumbersThatCountNoImagesAreRefused) {
    const std::vector<std::string> names = {"0.png", "39.png", "81.png", "119.png", "161.png"};
    expect_parts(import_names(names).refusal, {"irregularly", "--times-unit"});
    expect_times(import_names(names, std::nullopt, TimeUnit::Milliseconds).times_s,
                 {0, 0.039, 0.081, 0.119, 0.161});
}

TEST(ImageTimes, ImagesOfTwoCamerasInOneFolderAreRefused) {
    expect_parts(import_names({"left_0.png", "left_1.png", "right_0.png", "right_1.png"}, 25.0).refusal,
                 {"two cameras", "left_", "right_"});
    expect_parts(import_names({"0.png", "1.png", "1.bmp"}, 25.0).refusal, {"same number"});
    expect_parts(import_names({"cam0_0.png", "cam0_1.png", "cam1_0.png", "cam1_1.png"}, 25.0).refusal,
                 {"two cameras", "--times"});
}

TEST(ImageTimes, AListBesideTheImagesIsFound) {
    for (const char* name : {"data.csv", "timestamps.txt", "rgb.txt", "images.txt"}) {
        const fs::path folder = folder_with(three);
        write_bytes(folder.parent_path() / name,
                    "timestamp,filename\n0.5,000000.png\n0.6,000001.png\n0.7,000002.png\n");
        expect_times(import(folder, {}).times_s, {0.5, 0.6, 0.7});
        fs::remove(folder.parent_path() / name);
    }
    const fs::path folder = folder_with(three);
    write_bytes(folder.parent_path() / "data.csv", "when,what\nnow,that\n");
    EXPECT_EQ(import(folder, {}).times_s.size(), 3U) << "another kind of file with this name";
}

TEST(Pictures, HiddenFilesAreSkipped) {
    const fs::path folder = folder_with(three);
    for (const char* name : {"._000000.png", ".DS_Store", "Thumbs.db", ".hidden.jpg"})
        write_bytes(folder / name, "no picture");
    FrameTimes times;
    times.rate_hz = 25.0;
    const auto result = import(folder, times);
    EXPECT_EQ(result.times_s.size(), 3U);
    EXPECT_TRUE(result.problems.empty());
}

TEST(Pictures, AllUsualKindsAreRead) {
    for (const char* ending : {".png", ".jpg", ".bmp", ".pgm", ".ppm", ".tif", ".tiff", ".webp", ".PNG"}) {
        const fs::path folder = test_folder() / "kind";
        fs::create_directories(folder);
        cv::Mat picture(48, 64, CV_8UC3, cv::Scalar(90, 90, 90));
        if (std::string(ending) == ".pgm") picture = cv::Mat(48, 64, CV_8UC1, cv::Scalar(90));
        cv::imwrite((folder / ("a" + std::string(ending))).string(), picture);
        FrameTimes times;
        times.rate_hz = 25.0;
        ImageFolder sequence(folder, sample_camera(), times);
        const auto frame = sequence.next();
        ASSERT_TRUE(frame) << ending;
        EXPECT_NEAR(frame->field.image.at(9, 9), 90, 2) << ending;
        fs::remove_all(folder);
    }
}

TEST(Pictures, TenAndTwelveBitsAreScaledByWhatIsThere) {
    for (const auto& [bits, ending] :
         {std::pair{8, ".png"}, {10, ".png"}, {12, ".tif"}, {12, ".pgm"}, {16, ".png"}}) {
        const fs::path folder = test_folder() / "deep";
        fs::create_directories(folder);
        const int full = (1 << bits) - 1;
        for (int i = 0; i < 3; ++i) {
            cv::Mat_<std::uint16_t> picture(48, 64, static_cast<std::uint16_t>(full / 4));
            picture(5, 5) = static_cast<std::uint16_t>(full * 9 / 10);
            cv::imwrite((folder / (std::to_string(i) + ending)).string(), picture);
        }
        FrameTimes times;
        times.rate_hz = 25.0;
        ImageFolder sequence(folder, sample_camera(), times);
        const auto frame = sequence.next();
        ASSERT_TRUE(frame) << bits;
        EXPECT_NEAR(frame->field.image.at(20, 20), 64, 1) << bits;
        EXPECT_NEAR(frame->field.image.at(5, 5), 229, 1) << bits;
        EXPECT_TRUE(some_says(sequence.notes(), {"16 bits", ("use " + std::to_string(bits)).c_str()}));
        fs::remove_all(folder);
    }
}

TEST(Pictures, PicturesThatAreCutShortAreLeftOutAndNamed) {
    for (const std::string ending : {".jpg", ".png", ".bmp", ".tif", ".webp"}) {
        for (const double share : {0.3, 0.9}) {
            const fs::path folder = folder_with({"0" + ending, "1" + ending, "2" + ending});
            const fs::path victim = folder / ("1" + ending);
            fs::resize_file(victim,
                            static_cast<std::uintmax_t>(share * static_cast<double>(fs::file_size(victim))));
            FrameTimes times;
            times.rate_hz = 25.0;
            const auto result = import(folder, times);
            expect_times(result.times_s, {0, 0.08});
            EXPECT_TRUE(some_says(result.problems, {("1" + ending).c_str(), "cut short"})) << ending;
        }
    }
}

TEST(Pictures, AWholeJpegWithMoreBehindItsEndIsRead) {
    const fs::path folder = folder_with({"0.jpg"});
    std::ofstream(folder / "0.jpg", std::ios::binary | std::ios::app) << std::string(100, '\0') << "trailer";
    FrameTimes times;
    times.rate_hz = 25.0;
    EXPECT_EQ(import(folder, times).times_s.size(), 1U);
}

TEST(Pictures, APictureOfAnotherSizeIsLeftOutAndNamed) {
    const fs::path folder = folder_with(three);
    cv::imwrite((folder / "000001.png").string(), cv::Mat(40, 64, CV_8UC1, cv::Scalar(9)));
    FrameTimes times;
    times.rate_hz = 25.0;
    const auto result = import(folder, times);
    expect_times(result.times_s, {0, 0.08});
    EXPECT_TRUE(some_says(result.problems, {"000001.png", "64 x 40", "64 x 48"}));
}

}  // namespace
}  // namespace flownav::io
