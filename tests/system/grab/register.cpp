#include <mrpt/core/initializer.h>

#include "test_sensor.h"

MRPT_INITIALIZER(flownav_test_sensor) {
    flownav::testing::CTestSensor::doRegister();
}
