#include "flownav/drive/sensor_feed.h"

#include "flownav/pipeline/sensor_report.h"

namespace flownav {

nav::Sensed sensed_of(const pipeline::Step& step, const Field& field, pipeline::RepeatedImages& images,
                      double epoch_s) {
    nav::Sensed sensed;
    sensed.report = pipeline::sensor_report(step, field.camera);
    sensed.report.repeated = images.is_repeated(field.image);
    sensed.report.timestamp_s -= epoch_s;
    if (step.status == FieldStatus::Ok) sensed.T_start_robot = step.T_start_robot;
    if (step.end_of_cycle) {
        sensed.points = step.obstacles;
        sensed.ground = step.ground;
    }
    return sensed;
}

}  // namespace flownav
