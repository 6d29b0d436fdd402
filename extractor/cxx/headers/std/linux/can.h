// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sys/socket.h>
#include <stdint.h>
typedef uint32_t canid_t;
struct can_frame { canid_t can_id; uint8_t can_dlc; uint8_t data[8]; };
struct can_filter { canid_t can_id; canid_t can_mask; };
struct sockaddr_can { sa_family_t can_family; int can_ifindex; };
#define CAN_RAW 1
#define CAN_EFF_FLAG 0x80000000U
#define CAN_RTR_FLAG 0x40000000U
#define CAN_ERR_FLAG 0x20000000U
#define CAN_SFF_MASK 0x7FFU
#define CAN_EFF_MASK 0x1FFFFFFFU
#define CAN_RAW_FILTER 1
#define SOL_CAN_RAW 101
