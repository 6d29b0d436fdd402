#ifndef SONAR_BUS_H
#define SONAR_BUS_H

int bus_open(const char* device);
float bus_ping(int sonar);
void bus_power(bool on);

#endif
