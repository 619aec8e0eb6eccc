#pragma once
#include <mrpt/hwdrivers/CGenericSensor.h>

#include <string>

namespace flownav::testing {

/// A sensor controlled by its keys. Each turn it observes an odometry, labelled by its section, and on
/// request an image. It writes their label and time stamp to `journal` before it hands them out.
class CTestSensor : public mrpt::hwdrivers::CGenericSensor {
    DEFINE_GENERIC_SENSOR(CTestSensor)

  public:
    void initialize() override;
    void doProcess() override;

  protected:
    void loadConfig_sensorSpecific(const mrpt::config::CConfigFileBase& ini,
                                   const std::string& section) override;

  private:
    void observe();
    void note(const std::string& label, mrpt::Clock::time_point time) const;

    std::string section_;
    std::string journal_;
    std::string then_;  ///< behaviour after `turns`: nothing | throw | error | silence | hang | end
    int turns_ = 0;     ///< 0: no limit
    bool image_ = false;
    double lag_s_ = 0.0;  ///< delay of the time stamps behind the clock
    int turn_ = 0;
};

}  // namespace flownav::testing
