#include "sonar_bus.h"

#include <fcntl.h>
#include <unistd.h>

static int fd = -1;

int bus_open(const char* device)
{
  fd = open(device, O_RDWR);
  return fd >= 0 ? 0 : -1;
}

float bus_ping(int sonar)
{
  unsigned char command[2] = { 0x50, static_cast<unsigned char>(sonar) };
  unsigned char answer[2];
  if (write(fd, command, 2) != 2 || read(fd, answer, 2) != 2)
    return -1.0f;
  return (answer[0] << 8 | answer[1]) / 1000.0f;
}

void bus_power(bool on)
{
  unsigned char command[2] = { 0x51, static_cast<unsigned char>(on) };
  if (write(fd, command, 2) != 2)
    fd = -1;
}
