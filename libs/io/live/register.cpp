#include <mrpt/core/initializer.h>
#include <mrpt/rtti/CObject.h>

#include "flownav/io/flow_field_observation.h"
#include "flownav/io/flow_obstacle_sensor.h"

using flownav::CObservationFlowField;  // CLASS_ID() takes an unqualified name

MRPT_INITIALIZER(flownav_sensor) {
    mrpt::rtti::registerClass(CLASS_ID(CObservationFlowField));
    flownav::CFlowObstacleSensor::doRegister();
}
