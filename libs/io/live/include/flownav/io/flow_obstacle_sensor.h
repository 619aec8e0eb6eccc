#pragma once
#include <mrpt/hwdrivers/CGenericSensor.h>
#include <mrpt/system/COutputLogger.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "flownav/io/live_fields.h"
#include "flownav/pipeline/pipeline.h"

namespace flownav {

/// Thrown at the regular end of a file; what() holds the source and the number of fields.
struct EndOfInput : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The optic-flow obstacle sensor as a driver of MRPT: `rawlog-grabber -p libflownav-sensor.so grabber.ini`.
/// Publishes FLOW_ODOMETRY and FLOW_POSE for every field, and FLOW_SCAN and FLOW_POINTS at the end of a
/// cycle. Keys of its section of the ini (share/grabber.ini is an example):
///
///     driver         CFlowObstacleSensor
///     process_rate   calls a second; must exceed the field rate, as each call evaluates one field at most
///     grabber_type   opencv, ffmpeg, image_dir, rawlog, ...: as in CCameraSensor, with all of its keys,
///                    among them the pose of the camera (pose_z, ...)
///     flownav_config file name of an ini of flownav-replay; optional
///     camera.height_m and any other key of such an ini, as in --set; optional
///     label_prefix   prefix of the labels of all published observations; default FLOW
///     publish_image  publish the fields, with calibration, as camera.camera_label; default false
///     use_odometry   publish the ODOMETRY of a rawlog; default true
///     paced          play files in the time of the recording, not as fast as called; default false
///     rate_hz        images a second of a video or folder; default for a video: its own time stamps
///     start_time_s   time of the first image of a video or folder, since the epoch; default 0
///     end_wait_s     seconds from the end of the input to the final exception; default 5
///
/// Time stamps are the grabber's for live cameras and streams, the recorded ones for rawlogs, and
/// start_time_s and the stamps of the container, or i / rate_hz, for videos and folders. Stereo folders: only
/// the left images are used. Images are published embedded, never as external files. Unknown keys and
/// grab_decimation > 1 are errors.
///
/// At the end of its input the sensor appends a CObservationComment with the kind of the end. When the input
/// failed (device gone, damaged file) the state becomes ssError at once, with a message in the log. After
/// end_wait_s doProcess() throws: EndOfInput at a regular end, else InputError. rawlog-grabber takes half of
/// its queue every GRABBER_PERIOD_MS and ends only by an exception, which loses the rest; end_wait_s is the
/// time it has to empty the queue.
class CFlowObstacleSensor : public mrpt::system::COutputLogger, public mrpt::hwdrivers::CGenericSensor {
    DEFINE_GENERIC_SENSOR(CFlowObstacleSensor)

  public:
    CFlowObstacleSensor();
    ~CFlowObstacleSensor() override;

    /// Opens the source. Throws InputError or ConfigError and sets the state to ssError when it cannot be
    /// opened.
    void initialize() override;

    /// Evaluates the next field. Throws when end_wait_s have passed after the end of the input; throws
    /// std::logic_error before initialize().
    void doProcess() override;

    bool ended() const { return fields_ && fields_->ended(); }

    /// Reason why the input failed; empty when it did not.
    std::string error() const { return fields_ ? fields_->error() : ""; }

  protected:
    void loadConfig_sensorSpecific(const mrpt::config::CConfigFileBase& ini,
                                   const std::string& section) override;

  private:
    using Batch = std::vector<mrpt::serialization::CSerializable::Ptr>;

    std::optional<io::SensorEvent> next_due();
    void evaluate(const Field& field, Batch& batch);
    void add(Batch& batch, const mrpt::obs::CObservation::Ptr& observation, const char* suffix) const;
    void end(Batch& batch);
    void wait_and_throw();

    io::ProducerSettings settings_;
    std::optional<io::LiveFields> fields_;
    std::optional<pipeline::State> state_;
    std::optional<io::SensorEvent> early_;  ///< event that is read but not due yet
    std::optional<double> clock_offset_s_;  ///< clock minus time stamp; used when paced
    double latest_s_ = 0.0;                 ///< latest time stamp read
    double calls_since_end_ = 0.0;
    std::string end_text_;  ///< message about the end of the input; empty before it
};

}  // namespace flownav
