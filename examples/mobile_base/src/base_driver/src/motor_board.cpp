#include "motor_board.h"

#include <cstdio>

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

namespace base_driver
{
MotorBoard::~MotorBoard()
{
  if (fd_ >= 0)
    ::close(fd_);
}

bool MotorBoard::open(const std::string& device, int baud)
{
  fd_ = ::open(device.c_str(), O_RDWR | O_NOCTTY);
  if (fd_ < 0)
    return false;
  termios options;
  tcgetattr(fd_, &options);
  cfmakeraw(&options);
  const speed_t speed = baud == 115200 ? B115200 : B57600;
  cfsetispeed(&options, speed);
  cfsetospeed(&options, speed);
  return tcsetattr(fd_, TCSANOW, &options) == 0;
}

bool MotorBoard::setSpeeds(double left, double right)
{
  char line[64];
  const int size = snprintf(line, sizeof(line), "S %.3f %.3f\r\n", left, right);
  return ::write(fd_, line, size) == size;
}

bool MotorBoard::readTicks(int32_t& left, int32_t& right)
{
  char line[64] = { 0 };
  if (::write(fd_, "T\r\n", 3) != 3 || ::read(fd_, line, sizeof(line) - 1) <= 0)
    return false;
  return sscanf(line, "T %d %d", &left, &right) == 2;
}
}  // namespace base_driver
