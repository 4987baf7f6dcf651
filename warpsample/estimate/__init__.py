"""Monte Carlo estimates at surface points, such as ambient occlusion: values, standard errors and confidence intervals."""
