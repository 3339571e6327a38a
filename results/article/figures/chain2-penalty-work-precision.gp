# gnuplot chain2-penalty-work-precision.gp makes chain2-penalty-work-precision.svg and chain2-penalty-work-precision.pdf of chain2-penalty-work-precision.dat
data = 'chain2-penalty-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'chain2-penalty-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force [-]'
set xrange [1.54e-05:1.26e+01]
set yrange [1.29e-12:8.41e+00]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'event-driven[flow=modal]' at graph 1.06,0.0080 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 4.498130e-04,3.867267e-12 to graph 1.05,0.0080 nohead lc rgb '#D55E00' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.0700 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 4.707510e-04,3.867267e-12 to graph 1.05,0.0700 nohead lc rgb '#009E73' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1320 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 4.044445e-02,1.346211e-09 to graph 1.05,0.1320 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.1940 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.105117e-03,5.118709e-05 to graph 1.05,0.1940 nohead lc rgb '#E69F00' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.2560 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.484016e-01,5.118709e-05 to graph 1.05,0.2560 nohead lc rgb '#E69F00' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=100x]' at graph 1.06,0.3180 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 3.749259e-01,5.373841e-05 to graph 1.05,0.3180 nohead lc rgb '#000000' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.3800 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 2.125124e-02,7.145428e-05 to graph 1.05,0.3800 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.4420 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 1.455935e-03,8.881538e-05 to graph 1.05,0.4420 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'closed-hbm' at graph 1.06,0.5040 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.154946e-03,8.881538e-05 to graph 1.05,0.5040 nohead lc rgb '#000000' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.5660 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.209555e-03,8.881538e-05 to graph 1.05,0.5660 nohead lc rgb '#0072B2' lw 0.5 back
set label 'hat-lcp[plain=true]' at graph 1.06,0.6280 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 1.714926e-03,1.419143e-02 to graph 1.05,0.6280 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'aft-hbm[plain=true,continuation=frequency]' at graph 1.06,0.6900 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 2.696535e+00,1.723196e-02 to graph 1.05,0.6900 nohead lc rgb '#D55E00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1]' at graph 1.06,0.7520 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 4.931489e-01,1.723196e-02 to graph 1.05,0.7520 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'fourier-lipschitz[plain=true,continuation=frequency]' at graph 1.06,0.8140 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 4.199319e+00,1.723196e-02 to graph 1.05,0.8140 nohead lc rgb '#E69F00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e3]' at graph 1.06,0.8760 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 3.367655e-01,2.769608e-02 to graph 1.05,0.8760 nohead lc rgb '#000000' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e5]' at graph 1.06,0.9380 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 7.428952e-01,3.829310e-01 to graph 1.05,0.9380 nohead lc rgb '#0072B2' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true,c=1e5]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 6.410013e-01,3.829310e-01 to graph 1.05,1.0000 nohead lc rgb '#009E73' lw 0.5 back
set label '10 error bars' at graph 0.99, first 3.867267e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 1.001600e-04,6.827084e-01 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 1.299760e-04,4.309805e-01 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 4.597690e-04,1.534222e-01 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 6.119080e-04,6.590027e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 7.682030e-04,1.038669e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 1.209555e-03,8.881538e-05 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 4.312502e-03,7.357904e-01 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '40' at 1.126449e-01,1.756775e-01 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '160' at 2.696535e+00,1.723196e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '10, 1e5' at 4.041840e-04,2.802893e+00 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '40, 1e5' at 6.981946e-03,1.651897e+00 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160, 1e5' at 6.410013e-01,3.829310e-01 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '5' at 1.812580e-04,3.619875e-01 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '10' at 3.210270e-04,2.379215e-01 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 9.472330e-04,9.387614e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 4.071707e-03,3.295801e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 2.166934e-02,5.805059e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.484016e-01,5.118709e-05 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '5' at 5.947250e-05,6.827084e-01 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '10' at 7.557300e-05,4.309805e-01 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '20' at 2.167150e-04,1.534222e-01 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 7.771631e-03,1.896580e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 1.342994e-02,4.343415e-06 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-8' at 1.966906e-02,3.998607e-08 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-10' at 4.044445e-02,1.346211e-09 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 4.130720e-04,1.209768e-07 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '1e-6' at 4.498130e-04,3.867267e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '64' at 1.032610e-04,3.867267e-12 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '20' at 2.962310e-04,1.534222e-01 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '10' at 7.910630e-03,7.357904e-01 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 2.597470e-01,1.756775e-01 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 4.199319e+00,1.723196e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '10, 1' at 2.692466e-03,7.357904e-01 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '40, 1' at 2.537722e-02,1.756775e-01 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '160, 1' at 4.931489e-01,1.723196e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '10, 1e3' at 4.557090e-04,5.816865e-01 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40, 1e3' at 7.855279e-03,2.105491e-01 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160, 1e3' at 3.367655e-01,2.769608e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '10, 1e5' at 2.176130e-04,2.802893e+00 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '128' at 1.219610e-04,1.601981e-01 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '512' at 2.262116e-03,1.419143e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 4.884084e-03,1.600782e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 2.125124e-02,7.145428e-05 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '512' at 1.714926e-03,1.419143e-02 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '5' at 4.629700e-05,3.619875e-01 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '10' at 7.752700e-05,2.379215e-01 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 2.132640e-04,9.387614e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 5.381480e-04,3.295801e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 9.312530e-04,5.805059e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.105117e-03,5.118709e-05 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '10' at 8.196710e-04,2.379643e-01 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40' at 1.047217e-02,3.390975e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 3.749259e-01,5.373841e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#D55E00' dt '-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#D55E00' pt 7 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 5 with points lc rgb '#009E73' pt 9 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 7 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 9 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 10 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 11 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  data index 12 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 13 with points lc rgb '#D55E00' pt 9 ps 1.1 notitle, \
  data index 14 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 15 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 16 with points lc rgb '#009E73' pt 10 ps 1.1 notitle, \
  data index 17 with lines lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 18 with points lc rgb '#CC79A7' pt 13 ps 1.1 notitle, \
  data index 19 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle, \
  data index 20 with points lc rgb '#E69F00' pt 15 ps 1.1 notitle, \
  data index 21 with lines lc rgb '#56B4E9' dt '.' lw 1.6 notitle, \
  data index 22 with points lc rgb '#56B4E9' pt 5 ps 1.1 notitle, \
  data index 23 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 24 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 25 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 26 with points lc rgb '#0072B2' pt 9 ps 1.1 notitle, \
  data index 27 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 28 with points lc rgb '#009E73' pt 13 ps 1.1 notitle, \
  data index 29 with lines lc rgb '#CC79A7' dt '.' lw 1.6 notitle, \
  data index 30 with points lc rgb '#CC79A7' pt 15 ps 1.1 notitle, \
  data index 31 with lines lc rgb '#E69F00' dt '_.' lw 1.6 notitle, \
  data index 32 with points lc rgb '#E69F00' pt 5 ps 1.1 notitle, \
  data index 33 with lines lc rgb '#000000' dt 1 lw 1.6 notitle, \
  data index 34 with points lc rgb '#000000' pt 9 ps 1.1 notitle, \
  3.867267e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
