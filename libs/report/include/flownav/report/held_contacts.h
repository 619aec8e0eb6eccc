#pragma once
#include "flownav/pipeline/step.h"

namespace flownav::report {

/// The newest contact scan of a drive, for pictures of this field and those after it.
class HeldContacts {
  public:
    /// Takes the scan of a step that has a new one; else moves the held scan along with the robot. A step
    /// that restarts the chain drops it.
    void take(const pipeline::Step& step);

    /// The scan in the robot frame of the last step; its gate is ContactGate::Off while there is none.
    const ContactScan& scan() const { return scan_; }

  private:
    ContactScan scan_;
    Pose2 T_start_robot_;
};

}  // namespace flownav::report
