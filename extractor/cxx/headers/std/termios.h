// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
typedef unsigned char cc_t;
typedef unsigned int speed_t;
typedef unsigned int tcflag_t;
struct termios { tcflag_t c_iflag, c_oflag, c_cflag, c_lflag; cc_t c_line; cc_t c_cc[32]; speed_t c_ispeed, c_ospeed; };
struct termio { unsigned short c_iflag, c_oflag, c_cflag, c_lflag; unsigned char c_line; unsigned char c_cc[8]; };
#ifdef __cplusplus
extern "C" {
#endif
int tcgetattr(int, struct termios*); int tcsetattr(int, int, const struct termios*); int tcflush(int, int); int tcdrain(int);
  int tcsendbreak(int, int); int tcflow(int, int);
speed_t cfgetispeed(const struct termios*); speed_t cfgetospeed(const struct termios*); int cfsetispeed(struct termios*, speed_t);
  int cfsetospeed(struct termios*, speed_t);
int cfsetspeed(struct termios*, speed_t); void cfmakeraw(struct termios*);
#ifdef __cplusplus
}
#endif
enum {
  VINTR, VQUIT, VERASE, VKILL, VEOF, VTIME, VMIN, VSWTC, VSTART, VSTOP, VSUSP, VEOL, VREPRINT, VDISCARD, VWERASE, VLNEXT, VEOL2,
  IGNBRK = 1, BRKINT = 2, IGNPAR = 4, PARMRK = 8, INPCK = 16, ISTRIP = 32, INLCR = 64, IGNCR = 128, ICRNL = 256, IUCLC = 512, IXON = 1024,
    IXANY = 2048, IXOFF = 4096, IMAXBEL = 8192,
  OPOST = 1, OLCUC = 2, ONLCR = 4, OCRNL = 8, ONOCR = 16, ONLRET = 32, OFILL = 64,
  CSIZE = 48, CS5 = 0, CS6 = 16, CS7 = 32, CS8 = 48, CSTOPB = 64, CREAD = 128, PARENB = 256, PARODD = 512, HUPCL = 1024, CLOCAL = 2048,
  ISIG = 1, ICANON = 2, XCASE = 4, ECHO = 8, ECHOE = 16, ECHOK = 32, ECHONL = 64, NOFLSH = 128, TOSTOP = 256, ECHOCTL = 512, ECHOKE = 2048,
    IEXTEN = 32768,
  TCSANOW = 0, TCSADRAIN = 1, TCSAFLUSH = 2, TCIFLUSH = 0, TCOFLUSH = 1, TCIOFLUSH = 2, TCOOFF = 0, TCOON = 1,
  B0 = 0, B50 = 1, B75, B110, B134, B150, B200, B300, B600, B1200, B1800, B2400, B4800, B9600, B19200, B38400,
  B57600 = 4097, B115200, B230400, B460800, B500000, B576000, B921600, B1000000, B1152000, B1500000, B2000000, B2500000, B3000000, B3500000,
    B4000000
};
// A macro, because the enumerator CRTSCTS would not fit an int.
#define CRTSCTS 020000000000
