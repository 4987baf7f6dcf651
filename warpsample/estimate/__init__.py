"""Monte Carlo estimates at surface points, such as ambient occlusion, by one kernel that stores no rays."""
