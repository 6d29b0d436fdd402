// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>
#include <cstdint>
#include <stdexcept>
namespace serial {
enum bytesize_t { fivebits = 5, sixbits, sevenbits, eightbits }; enum parity_t { parity_none, parity_odd, parity_even };
  enum stopbits_t { stopbits_one = 1, stopbits_two = 2 };
  enum flowcontrol_t { flowcontrol_none, flowcontrol_software, flowcontrol_hardware };
  struct Timeout { static Timeout simpleTimeout(uint32_t); Timeout(uint32_t = 0, uint32_t = 0, uint32_t = 0, uint32_t = 0, uint32_t = 0);
  static uint32_t max(); };
class Serial { public: template <class... A> Serial(const A&...); void open(); bool isOpen() const; void close(); std::size_t available();
  bool waitReadable(); std::size_t read(uint8_t*, std::size_t); std::size_t read(std::vector<uint8_t>&, std::size_t = 1);
  std::size_t read(std::string&, std::size_t = 1); std::string read(std::size_t = 1);
  std::string readline(std::size_t = 65536, std::string = "\n");
  std::vector<std::string> readlines(std::size_t = 65536, std::string = "\n"); std::size_t write(const uint8_t*, std::size_t);
  std::size_t write(const std::vector<uint8_t>&); std::size_t write(const std::string&); void setPort(const std::string&);
  std::string getPort() const; void setTimeout(const Timeout&); void setBaudrate(uint32_t); uint32_t getBaudrate() const;
  void setBytesize(bytesize_t); void setParity(parity_t); void setStopbits(stopbits_t); void setFlowcontrol(flowcontrol_t); void flush();
  void flushInput(); void flushOutput(); void setDTR(bool = true); void setRTS(bool = true); };
class SerialException : public std::runtime_error { public: SerialException(const char*); }; typedef SerialException IOException;
  typedef SerialException PortNotOpenedException; struct PortInfo { std::string port, description, hardware_id; };
  std::vector<PortInfo> list_ports();
}
