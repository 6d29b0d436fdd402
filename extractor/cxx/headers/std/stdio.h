// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/c_types.h>
#include <stdarg.h>
struct _IO_FILE;
typedef struct _IO_FILE FILE;
typedef struct { long offset; } fpos_t;
#ifdef __cplusplus
extern "C" {
#endif
extern FILE* stdin;
extern FILE* stdout;
extern FILE* stderr;
int printf(const char*, ...);
int fprintf(FILE*, const char*, ...);
int dprintf(int, const char*, ...);
int sprintf(char*, const char*, ...);
int snprintf(char*, size_t, const char*, ...);
int asprintf(char**, const char*, ...);
int vprintf(const char*, va_list);
int vfprintf(FILE*, const char*, va_list);
int vsprintf(char*, const char*, va_list);
int vsnprintf(char*, size_t, const char*, va_list);
int vasprintf(char**, const char*, va_list);
int scanf(const char*, ...);
int fscanf(FILE*, const char*, ...);
int sscanf(const char*, const char*, ...);
FILE* fopen(const char*, const char*);
FILE* freopen(const char*, const char*, FILE*);
FILE* fdopen(int, const char*);
FILE* popen(const char*, const char*);
FILE* tmpfile(void);
char* tmpnam(char*);
int pclose(FILE*);
int fclose(FILE*);
int fflush(FILE*);
int fileno(FILE*);
int fgetc(FILE*);
int fputc(int, FILE*);
int getc(FILE*);
int putc(int, FILE*);
int getchar(void);
int putchar(int);
int ungetc(int, FILE*);
char* fgets(char*, int, FILE*);
char* gets(char*);
int fputs(const char*, FILE*);
int puts(const char*);
ssize_t getline(char**, size_t*, FILE*);
ssize_t getdelim(char**, size_t*, int, FILE*);
size_t fread(void*, size_t, size_t, FILE*);
size_t fwrite(const void*, size_t, size_t, FILE*);
int fseek(FILE*, long, int);
int fseeko(FILE*, off_t, int);
long ftell(FILE*);
off_t ftello(FILE*);
void rewind(FILE*);
int fgetpos(FILE*, fpos_t*);
int fsetpos(FILE*, const fpos_t*);
int feof(FILE*);
int ferror(FILE*);
void clearerr(FILE*);
void perror(const char*);
int remove(const char*);
int rename(const char*, const char*);
void setbuf(FILE*, char*);
int setvbuf(FILE*, char*, int, size_t);
#ifdef __cplusplus
}
#endif
#define EOF (-1)
#define SEEK_SET 0
#define SEEK_CUR 1
#define SEEK_END 2
#define BUFSIZ 8192
#define FILENAME_MAX 4096
#define FOPEN_MAX 16
#define _IOFBF 0
#define _IOLBF 1
#define _IONBF 2
