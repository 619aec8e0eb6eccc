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

/// A file was read to its regular end; what() says how much came of it.
struct EndOfInput : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The optic-flow obstacle sensor as a driver of MRPT: `rawlog-grabber -p libflownav-sensor.so grabber.ini`.
/// For every field an odometry FLOW_ODOMETRY, and at the end of a cycle a scan FLOW_SCAN and the points
/// FLOW_POINTS. Keys of its section of the ini (share/grabber.ini is an example):
///
///     driver         CFlowObstacleSensor
///     process_rate   calls a second, more than there are fields; each evaluates one at most
///     grabber_type   opencv, ffmpeg, image_dir, rawlog, ...: as in CCameraSensor, with all keys of that,
///                    the pose of the camera (pose_z, ...) too
///     flownav_config an ini of flownav-replay; optional
///     camera.height_m and any other key of such an ini, as in --set; optional
///     label_prefix   of the labels of all that is published: FLOW
///     publish_image  the fields too, with their calibration, under camera.camera_label: false
///     use_odometry   the ODOMETRY of a rawlog comes along: true
///     paced          files in the time of the recording, not as fast as called: false
///     rate_hz        images of a video or folder a second; a video tells its own
///     start_time_s   of the first image of a video or folder, since the epoch: 0
///     end_wait_s     from the end of a file to the exception that ends all: 5
///
/// Time stamps: live cameras and streams, the grabber's; rawlogs, the recorded ones; videos and folders,
/// start_time_s + i / rate_hz. Of stereo pairs in a folder the left images are used. Images are published
/// embedded, never as external files. An unknown key is an error, and so is grab_decimation > 1.
///
/// At the end of its input the sensor appends a CObservationComment that says which end it was. When the
/// input failed (device gone, damaged file) the state is ssError at once, with a message in the log. After
/// end_wait_s doProcess() throws, EndOfInput at a regular end: an exception is all that ends rawlog-grabber,
/// which loses what is then still in its queue. It takes half of that queue every GRABBER_PERIOD_MS.
class CFlowObstacleSensor : public mrpt::system::COutputLogger, public mrpt::hwdrivers::CGenericSensor {
    DEFINE_GENERIC_SENSOR(CFlowObstacleSensor)

  public:
    CFlowObstacleSensor();
    ~CFlowObstacleSensor() override;

    /// Opens the source. Throws InputError with a message for people; the state is ssError then.
    void initialize() override;

    /// Evaluates the next field. Throws only after the end of the input.
    void doProcess() override;

    bool ended() const { return fields_ && fields_->ended(); }

    /// Why the input failed; empty when it did not.
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
    std::optional<io::SensorEvent> early_;  ///< read, but not due yet
    std::optional<double> clock_offset_s_;  ///< clock - time stamp, when paced
    double latest_s_ = 0.0;                 ///< time stamp of what was read last
    double calls_since_end_ = 0.0;
    std::string end_text_;  ///< which end the input had; empty before it
};

}  // namespace flownav
