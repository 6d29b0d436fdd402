# May have any member.
# expect: service_client fill
globals()["fi" + "ll"] = None
