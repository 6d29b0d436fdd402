#ifndef BASE_DRIVER_MOTOR_BOARD_H
#define BASE_DRIVER_MOTOR_BOARD_H

#include <cstdint>
#include <string>

namespace base_driver
{
/// The serial protocol of the motor board.
class MotorBoard
{
public:
  ~MotorBoard();

  bool open(const std::string& device, int baud);
  bool setSpeeds(double left, double right);
  bool readTicks(int32_t& left, int32_t& right);

private:
  int fd_ = -1;
};
}  // namespace base_driver

#endif
