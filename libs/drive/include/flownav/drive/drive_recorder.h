#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "flownav/drive/drive.h"

namespace flownav::drive {

struct DriveRecorderOptions {
    std::filesystem::path rawlog;  ///< fields, odometry and truth; empty: none
    std::filesystem::path csv;     ///< one row a decision of the navigator; empty: none
    /// What happens when the disk is slower than the drive: fields are left out and counted (a robot must not
    /// wait), or the drive waits (a simulation can).
    bool may_wait = false;
};

/// Writes a drive down while it happens, in a thread of its own: neither the camera nor the motors wait for
/// the disk, unless `may_wait`.
class DriveRecorder : public DriveObserver {
  public:
    /// Throws OutputError: a file cannot be made.
    explicit DriveRecorder(const DriveRecorderOptions& options);
    ~DriveRecorder() override;

    void on_field(const Field& field, const pipeline::Step& step) override;
    void on_odometry(double timestamp_s, const Pose2& T_odom_robot) override;
    void on_truth(double timestamp_s, const Pose2& T_world_robot) override;
    void on_decision(const DriveSample& sample, const nav::NavigationStack& stack) override;

    /// Writes what still waits, and gives the files their names. Throws OutputError, also for what could not
    /// be written while the robot drove.
    void complete();

    /// Fields that were left out because the disk was too slow.
    int fields_left_out() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The columns of the csv, and one row.
std::string drive_csv_header();
std::string drive_csv_row(const DriveSample& sample, const nav::RecoveryDecision& decision,
                          nav::GuardAction action);

}  // namespace flownav::drive
