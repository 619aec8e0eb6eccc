#pragma once
#include "flownav/io/flow_field_observation.h"

/// Hand-made flow fields in which all numbers differ.
namespace flownav::testing {

/// A finished cycle with every label, every kind and cause of a beam, and a contact scan.
CObservationFlowField::Ptr rich_flow_field();

/// The same as a file of an earlier version tells it.
CObservationFlowField::Ptr rich_flow_field_of_version(int version);

/// The first field of a drive, without vectors.
CObservationFlowField::Ptr first_flow_field();

/// Compares every number; fails the test at a difference.
void expect_equal(const CObservationFlowField& a, const CObservationFlowField& b);

}  // namespace flownav::testing
