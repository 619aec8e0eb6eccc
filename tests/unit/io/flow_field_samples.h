#pragma once
#include "flownav/io/flow_field_observation.h"

/// Hand-made flow fields, in which no two numbers are alike.
namespace flownav::testing {

/// A finished cycle with every label and every kind of beam.
CObservationFlowField::Ptr rich_flow_field();

/// The first field of a drive: nothing in it yet.
CObservationFlowField::Ptr first_flow_field();

/// Compares every number; fails the test where one differs.
void expect_equal(const CObservationFlowField& a, const CObservationFlowField& b);

}  // namespace flownav::testing
