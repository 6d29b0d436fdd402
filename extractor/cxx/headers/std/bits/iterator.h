// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/utility.h>
namespace std {
struct input_iterator_tag {};
struct output_iterator_tag {};
struct forward_iterator_tag : input_iterator_tag {};
struct bidirectional_iterator_tag : forward_iterator_tag {};
struct random_access_iterator_tag : bidirectional_iterator_tag {};
template <class Category, class T, class D = ptrdiff_t, class P = T*, class R = T&> struct iterator {
  typedef Category iterator_category;
  typedef T value_type;
  typedef D difference_type;
  typedef P pointer;
  typedef R reference;
};
template <class I, class = void> struct iterator_traits {};
template <class I> struct iterator_traits<I, void_t<typename I::iterator_category>> {
  typedef typename I::iterator_category iterator_category;
  typedef typename I::value_type value_type;
  typedef typename I::difference_type difference_type;
  typedef typename I::pointer pointer;
  typedef typename I::reference reference;
};
template <class T> struct iterator_traits<T*, void> {
  typedef random_access_iterator_tag iterator_category;
  typedef typename remove_cv<T>::type value_type;
  typedef ptrdiff_t difference_type;
  typedef T* pointer;
  typedef T& reference;
};
// One iterator for all containers. It offers all operations whatever the container; T is const for const_iterator.
template <class T, class Container> class rosarch_iterator {
public:
  typedef random_access_iterator_tag iterator_category;
  typedef typename remove_cv<T>::type value_type;
  typedef ptrdiff_t difference_type;
  typedef T* pointer;
  typedef T& reference;
  rosarch_iterator();
  rosarch_iterator(const rosarch_iterator&) = default;
  template <class U, class = typename enable_if<__is_same(const U, T)>::type> rosarch_iterator(const rosarch_iterator<U, Container>&);
  rosarch_iterator& operator=(const rosarch_iterator&);
  T& operator*() const;
  T* operator->() const;
  T& operator[](ptrdiff_t) const;
  rosarch_iterator& operator++();
  rosarch_iterator operator++(int);
  rosarch_iterator& operator--();
  rosarch_iterator operator--(int);
  rosarch_iterator& operator+=(ptrdiff_t);
  rosarch_iterator& operator-=(ptrdiff_t);
  rosarch_iterator operator+(ptrdiff_t) const;
  rosarch_iterator operator-(ptrdiff_t) const;
  T* base() const;
};
template <class T, class U, class C> bool operator==(const rosarch_iterator<T, C>&, const rosarch_iterator<U, C>&);
template <class T, class U, class C> bool operator!=(const rosarch_iterator<T, C>&, const rosarch_iterator<U, C>&);
template <class T, class U, class C> bool operator<(const rosarch_iterator<T, C>&, const rosarch_iterator<U, C>&);
template <class T, class U, class C> bool operator>(const rosarch_iterator<T, C>&, const rosarch_iterator<U, C>&);
template <class T, class U, class C> bool operator<=(const rosarch_iterator<T, C>&, const rosarch_iterator<U, C>&);
template <class T, class U, class C> bool operator>=(const rosarch_iterator<T, C>&, const rosarch_iterator<U, C>&);
template <class T, class U, class C> ptrdiff_t operator-(const rosarch_iterator<T, C>&, const rosarch_iterator<U, C>&);
template <class T, class C> rosarch_iterator<T, C> operator+(ptrdiff_t, const rosarch_iterator<T, C>&);
template <class I> class reverse_iterator {
public:
  typedef I iterator_type;
  typedef typename iterator_traits<I>::iterator_category iterator_category;
  typedef typename iterator_traits<I>::value_type value_type;
  typedef typename iterator_traits<I>::difference_type difference_type;
  typedef typename iterator_traits<I>::pointer pointer;
  typedef typename iterator_traits<I>::reference reference;
  reverse_iterator();
  explicit reverse_iterator(I);
  template <class J> reverse_iterator(const reverse_iterator<J>&);
  I base() const;
  reference operator*() const;
  pointer operator->() const;
  reference operator[](difference_type) const;
  reverse_iterator& operator++();
  reverse_iterator operator++(int);
  reverse_iterator& operator--();
  reverse_iterator operator--(int);
  reverse_iterator& operator+=(difference_type);
  reverse_iterator operator+(difference_type) const;
  reverse_iterator operator-(difference_type) const;
};
template <class I, class J> bool operator==(const reverse_iterator<I>&, const reverse_iterator<J>&);
template <class I, class J> bool operator!=(const reverse_iterator<I>&, const reverse_iterator<J>&);
template <class I, class J> bool operator<(const reverse_iterator<I>&, const reverse_iterator<J>&);
template <class I, class J> ptrdiff_t operator-(const reverse_iterator<I>&, const reverse_iterator<J>&);
template <class I, class D> void advance(I&, D);
template <class I> typename iterator_traits<I>::difference_type distance(I, I);
template <class I> I next(I, ptrdiff_t = 1);
template <class I> I prev(I, ptrdiff_t = 1);
template <class C> auto begin(C& c) -> decltype(c.begin());
template <class C> auto begin(const C& c) -> decltype(c.begin());
template <class T, size_t n> T* begin(T (&)[n]);
template <class C> auto end(C& c) -> decltype(c.end());
template <class C> auto end(const C& c) -> decltype(c.end());
template <class T, size_t n> T* end(T (&)[n]);
template <class C> auto cbegin(const C& c) -> decltype(c.begin());
template <class C> auto cend(const C& c) -> decltype(c.end());
template <class C> auto rbegin(C& c) -> decltype(c.rbegin());
template <class C> auto rend(C& c) -> decltype(c.rend());
template <class C> auto size(const C& c) -> decltype(c.size());
template <class T, size_t n> constexpr size_t size(const T (&)[n]) { return n; }
template <class C> auto empty(const C& c) -> decltype(c.empty());
template <class C> auto data(C& c) -> decltype(c.data());
}
