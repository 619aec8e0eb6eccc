#include "flownav/io/flow_field_observation.h"

#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cstring>
#include <sstream>

#include "flow_field_samples.h"

namespace flownav {
namespace {

using mrpt::serialization::archiveFrom;
using testing::expect_equal;
using testing::first_flow_field;
using testing::rich_flow_field;
using testing::rich_flow_field_of_version;

std::vector<std::uint8_t> bytes_of(const CObservationFlowField& observation) {
    mrpt::io::CMemoryStream memory;
    archiveFrom(memory) << observation;
    const auto* data = static_cast<const std::uint8_t*>(memory.getRawBufferData());
    return {data, data + memory.getTotalBytesCount()};
}

CObservationFlowField::Ptr read_from(const std::vector<std::uint8_t>& bytes) {
    mrpt::rtti::registerClass(CLASS_ID(CObservationFlowField));
    mrpt::io::CMemoryStream memory;
    memory.Write(bytes.data(), bytes.size());
    memory.Seek(0);
    return archiveFrom(memory).ReadObject<CObservationFlowField>();
}

/// Offset of the 4-byte number `value` in `bytes`.
std::size_t place_of(std::uint32_t value, const std::vector<std::uint8_t>& bytes) {
    for (std::size_t i = 0; i + 4 <= bytes.size(); ++i)
        if (std::memcmp(&bytes[i], &value, 4) == 0) return i;
    ADD_FAILURE() << value << " is not there";
    return 0;
}

std::string described(const CObservationFlowField& observation) {
    std::ostringstream text;
    observation.getDescriptionAsText(text);
    return text.str();
}

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

TEST(FlowFieldObservation, EveryNumberSurvivesItsStorage) {
    const auto rich = rich_flow_field();
    expect_equal(*read_from(bytes_of(*rich)), *rich);
    const auto first = first_flow_field();
    expect_equal(*read_from(bytes_of(*first)), *first);
}

TEST(FlowFieldObservation, EveryStatusSurvivesItsStorage) {
    for (const FieldStatus status : all_field_statuses) {
        const auto field = first_flow_field();
        field->step.status = status;
        EXPECT_EQ(read_from(bytes_of(*field))->step.status, status);
    }
}

TEST(FlowFieldObservation, FilesOfEveryEarlierVersionStillLoad) {
    mrpt::rtti::registerClass(CLASS_ID(CObservationFlowField));
    for (const int version : {0, 1}) {
        SCOPED_TRACE(version);
        const std::string name = "/flow_field_v" + std::to_string(version) + ".rawlog";
        mrpt::io::CFileGZInputStream file(FLOWNAV_FLOW_FIELD_FILES + name);
        auto archive = archiveFrom(file);
        expect_equal(*archive.ReadObject<CObservationFlowField>(), *first_flow_field());
        expect_equal(*archive.ReadObject<CObservationFlowField>(), *rich_flow_field_of_version(version));
        EXPECT_THROW(archive.ReadObject(), mrpt::serialization::CExceptionEOF);
    }
}

TEST(FlowFieldObservation, AContactScanIsStoredWithTheFieldThatMadeItOnly) {
    const auto field = rich_flow_field();
    field->step.new_contacts = false;
    const auto read = read_from(bytes_of(*field));
    EXPECT_FALSE(read->step.new_contacts);
    EXPECT_TRUE(read->step.contacts.strips.empty());
    EXPECT_EQ(read->step.contacts.gate, ContactGate::Off);
}

TEST(FlowFieldObservation, EveryGateAndEverySourceSurvivesItsStorage) {
    const auto field = rich_flow_field();
    for (const ContactGate gate : all_contact_gates) {
        field->step.contacts.gate = gate;
        EXPECT_EQ(read_from(bytes_of(*field))->step.contacts.gate, gate);
    }
    for (const MotionSource source :
         {MotionSource::Prediction, MotionSource::Flow, MotionSource::Wheels, MotionSource::Gyro}) {
        field->step.motion.forward_source = source;
        EXPECT_EQ(read_from(bytes_of(*field))->step.motion.forward_source, source);
    }
}

TEST(FlowFieldObservation, AVersionOfTheFutureIsRefused) {
    auto bytes = bytes_of(*first_flow_field());
    const std::string name = "flownav::CObservationFlowField";
    bytes[1 + name.size()] = 3;  // offset after the length and the name of the class
    try {
        read_from(bytes);
        FAIL() << "was read";
    } catch (const std::exception& error) {
        EXPECT_NE(std::string(error.what()).find("serialization version"), std::string::npos) << error.what();
    }
}

TEST(FlowFieldObservation, AHugeLengthIsRefusedWithoutAllocatingIt) {
    const auto field = first_flow_field();
    field->step.blocks.resize(77777);  // a number that is unique in the bytes
    auto bytes = bytes_of(*field);
    const std::size_t at = place_of(77777, bytes);
    for (const std::uint32_t size : {0x80000000U, 0xFFFFFFFFU, 1U << 21}) {
        std::memcpy(&bytes[at], &size, 4);
        EXPECT_THROW(read_from(bytes), std::exception) << size;
    }
    const std::uint32_t more_than_there_is = 1U << 20;
    std::memcpy(&bytes[at], &more_than_there_is, 4);
    EXPECT_THROW(read_from(bytes), std::exception);
}

TEST(FlowFieldObservation, DamageAnywhereIsAnErrorOrAnotherNumberAndACutAlwaysAnError) {
    const auto bytes = bytes_of(*rich_flow_field());
    for (std::size_t i = 0; i < bytes.size(); i += 47) {
        auto damaged = bytes;
        damaged[i] = static_cast<std::uint8_t>(~damaged[i]);
        try {
            read_from(damaged);
        } catch (const std::exception& error) {
            EXPECT_NE(std::string(error.what()), "");
        }
        const std::vector<std::uint8_t> cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(i));
        EXPECT_THROW(read_from(cut), std::exception) << "after " << i << " bytes";
    }
}

TEST(FlowFieldObservation, HasTheTimeOfItsRecord) {
    const auto field = rich_flow_field();
    EXPECT_NEAR(mrpt::Clock::toDouble(field->timestamp), field->step.timestamp_s, 1e-6);
    EXPECT_EQ(field->sensorLabel, "FLOW_FIELD");
}

TEST(FlowFieldObservation, ThePoseIsThatOfTheCamera) {
    const auto field = rich_flow_field();
    mrpt::poses::CPose3D pose;
    field->getSensorPose(pose);
    EXPECT_NEAR(pose.x(), 0.1, 1e-12);
    EXPECT_NEAR(pose.y(), 0.05, 1e-12);
    EXPECT_NEAR(pose.z(), 0.9, 1e-12);
    CObservationFlowField other;
    other.setSensorPose(pose);
    EXPECT_NEAR(other.camera.mount.height_m, 0.9, 1e-9);
    EXPECT_NEAR(other.camera.mount.pitch_rad, 0.4363, 1e-9);
    EXPECT_NEAR(other.camera.mount.roll_rad, 0.02, 1e-9);
    EXPECT_NEAR(other.camera.mount.yaw_rad, -0.03, 1e-9);
}

TEST(FlowFieldObservation, TheDescriptionSaysWhatThereIsWithUnits) {
    const std::string text = described(*rich_flow_field());
    for (const char* part :
         {"FLOW_FIELD", "768 x 288 px", "25.00 deg down", "Status: ok", "deg/s", "m/s (measured)",
          "Blocks: 8; placed 350", "by fate: unplaced 1 sifted 1 eliminated 1 ground 1 obstacle 1 moving 1",
          "Obstacle points: 2", "moves by itself", "7 beams of 11.46 deg", "5 end at an obstacle",
          "deg (gyro)", "m (carried over)",
          "Contact scan: poor_floor; 6 strips, 4 end at an obstacle, 1 are free", "  wall at "}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << " is missing in\n" << text;
    }
}

TEST(FlowFieldObservation, ARowHasTheColumnsOfItsHeader) {
    const auto field = rich_flow_field();
    ASSERT_TRUE(field->exportTxtSupported());
    const std::string header = field->exportTxtHeader();
    const auto columns = words_of(header.substr(0, header.find(", then")));
    const auto row = words_of(field->exportTxtDataRow());
    const auto value = [&](const char* name) {
        const auto at = std::find(columns.begin(), columns.end(), name) - columns.begin();
        return std::stod(row.at(static_cast<std::size_t>(at)));
    };
    EXPECT_EQ(header.find('\n'), std::string::npos);
    EXPECT_EQ(value("status"), 0);
    EXPECT_EQ(value("cycle_images"), 5);
    EXPECT_EQ(value("v_mps"), 0.3);
    EXPECT_EQ(value("sigma_forward_m"), 1.0);
    EXPECT_EQ(value("yaw_rad"), 1.3);
    EXPECT_EQ(value("placed"), 350);
    EXPECT_EQ(value("moving"), 2);
    EXPECT_EQ(value("blocks"), 8);
    EXPECT_EQ(value("obstacles"), 2);
    const std::size_t of_lists = std::size_t{8} * 22 + std::size_t{2} * 7;
    EXPECT_EQ(row.size(), columns.size() + of_lists + 10 + std::size_t{6} * 9);
    EXPECT_NEAR(std::stod(row[columns.size()]), field->step.blocks[0].vector.at_px.x(), 1e-8);
    EXPECT_EQ(std::stod(row[columns.size() + std::size_t{22} * 3 + 18]), 3)
        << "the fate of the block that is ground";
    EXPECT_EQ(row[columns.size() + of_lists - 1], "1") << "the second obstacle moves";
}

TEST(FlowFieldObservation, ARowEndsWithTheSourcesAndTheStripsOfTheContactScan) {
    const auto field = rich_flow_field();
    const auto row = words_of(field->exportTxtDataRow());
    const std::size_t strips = row.size() - std::size_t{6} * 9;
    EXPECT_EQ(row[strips - 10], "3") << "the gyro told the turn";
    EXPECT_EQ(row[strips - 9], "0") << "the travel was carried over";
    EXPECT_EQ(row[strips - 8], "1") << "the scan is new";
    EXPECT_EQ(row[strips - 7], "3") << "too little floor fits";
    EXPECT_EQ(row[strips - 1], "6") << "strips";
    const ContactScan& scan = field->step.contacts;
    EXPECT_NEAR(std::stod(row[strips]), -2.5 * scan.step, 1e-8) << "the first strip is to the left";
    EXPECT_NEAR(std::stod(row[strips + 3 * 9 + 4]), scan.strips[3].contact_m, 1e-8);
    EXPECT_EQ(row[strips + 3 * 9 + 2], "3") << "a wall";
    field->step.new_contacts = false;
    EXPECT_EQ(words_of(field->exportTxtDataRow()).back(), "0") << "no strips";
}

}  // namespace
}  // namespace flownav
