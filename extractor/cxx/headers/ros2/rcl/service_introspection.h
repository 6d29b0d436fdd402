// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
typedef enum rcl_service_introspection_state_e { RCL_SERVICE_INTROSPECTION_OFF, RCL_SERVICE_INTROSPECTION_METADATA, RCL_SERVICE_INTROSPECTION_CONTENTS } rcl_service_introspection_state_t;
