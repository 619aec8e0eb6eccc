#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "flownav/drive/drive.h"

namespace flownav::drive {

struct DriveRecorderOptions {
    std::filesystem::path rawlog;  ///< fields, odometry and truth; empty: none
    std::filesystem::path csv;     ///< one row per decision of the navigator; empty: none
    /// With a disk slower than the drive: true lets the drive wait (simulation only), false drops fields and
    /// counts them.
    bool may_wait = false;
};

/// Records a drive in its own thread. Camera and motors never wait for the disk, unless `may_wait`.
class DriveRecorder : public DriveObserver {
  public:
    /// Creates the files. Throws OutputError when one cannot be created.
    explicit DriveRecorder(const DriveRecorderOptions& options);
    ~DriveRecorder() override;

    void on_field(const Field& field, const pipeline::Step& step) override;
    void on_odometry(double timestamp_s, const Pose2& T_odom_robot) override;
    void on_truth(double timestamp_s, const Pose2& T_world_robot,
                  const Eigen::Isometry3d& T_flat_robot) override;
    void on_decision(const DriveSample& sample, const nav::NavigationStack& stack) override;

    /// Writes all waiting data, closes the files and renames the rawlog to its final name. Throws
    /// OutputError, also for write errors during the drive.
    void complete();

    /// Number of fields dropped because the disk was too slow.
    int fields_left_out() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Header and row of the csv, each with its newline.
std::string drive_csv_header();
std::string drive_csv_row(const DriveSample& sample, const nav::RecoveryDecision& decision,
                          nav::GuardAction action);

}  // namespace flownav::drive
