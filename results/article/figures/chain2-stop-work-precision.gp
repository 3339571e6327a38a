# gnuplot chain2-stop-work-precision.gp makes chain2-stop-work-precision.svg and chain2-stop-work-precision.pdf of chain2-stop-work-precision.dat
data = 'chain2-stop-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'chain2-stop-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force [-]'
set xrange [2.72e-05:3.77e+00]
set yrange [1.50e-12:2.85e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'event-driven[flow=modal]' at graph 1.06,0.0423 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.806120e-04,4.489287e-12 to graph 1.05,0.0423 nohead lc rgb '#D55E00' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1043 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 2.765530e-04,4.489287e-12 to graph 1.05,0.1043 nohead lc rgb '#009E73' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1663 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.231711e-02,6.122950e-11 to graph 1.05,0.1663 nohead lc rgb '#0072B2' lw 0.5 back
set label 'closed-hbm' at graph 1.06,0.3180 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 8.673630e-04,4.224794e-04 to graph 1.05,0.3180 nohead lc rgb '#000000' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.3800 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.201408e-02,3.704387e-03 to graph 1.05,0.3800 nohead lc rgb '#009E73' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true,c=1e5]' at graph 1.06,0.4420 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 3.813172e-02,2.848846e-02 to graph 1.05,0.4420 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e5]' at graph 1.06,0.5040 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.837477e-02,2.848846e-02 to graph 1.05,0.5040 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.5660 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 2.231654e-02,3.078797e-02 to graph 1.05,0.5660 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.6280 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.905468e-02,3.078797e-02 to graph 1.05,0.6280 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.6900 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 5.234889e-02,3.200561e-02 to graph 1.05,0.6900 nohead lc rgb '#E69F00' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e5x]' at graph 1.06,0.7520 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.857763e-02,3.296584e-02 to graph 1.05,0.7520 nohead lc rgb '#D55E00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e3]' at graph 1.06,0.8140 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 4.968356e-02,5.665804e-02 to graph 1.05,0.8140 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e4x]' at graph 1.06,0.8760 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 3.468955e-02,7.770625e-02 to graph 1.05,0.8760 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1]' at graph 1.06,0.9380 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 1.257311e+00,8.752569e-02 to graph 1.05,0.9380 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,1.0000 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 4.833679e-02,9.422082e-02 to graph 1.05,1.0000 nohead lc rgb '#E69F00' lw 0.5 back
set label '10 error bars' at graph 0.99, first 4.489287e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '80' at 1.165950e-02,6.215808e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 1.905468e-02,3.078797e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40, 1e5' at 3.053079e-03,9.406123e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160, 1e5' at 3.813172e-02,2.848846e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '40' at 4.833679e-02,9.422082e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 1.472050e-02,4.653116e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '5' at 4.117890e-04,6.761893e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '10' at 4.199940e-04,2.540333e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '20' at 4.388800e-04,9.283311e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40' at 4.778840e-04,3.339746e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '80' at 5.771530e-04,1.191050e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 8.673630e-04,4.224794e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 3.285269e-03,1.417666e-05 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 7.160945e-03,2.264217e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-8' at 1.057957e-02,4.039629e-09 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-10' at 1.231711e-02,6.122950e-11 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 1.699610e-04,1.712643e-10 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '1e-6' at 1.792990e-04,4.489287e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '64' at 8.174500e-05,4.489287e-12 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '256' at 2.765530e-04,4.489287e-12 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160, 1' at 1.257311e+00,8.752569e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '160, 1e3' at 4.968356e-02,5.665804e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40, 1e5' at 2.194143e-03,9.406123e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '512' at 6.057870e-04,6.036996e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 2.958666e-03,1.485072e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 1.201408e-02,3.704387e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '80' at 1.736403e-02,6.469975e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 5.234889e-02,3.200561e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 3.468955e-02,7.770625e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 3 with points lc rgb '#009E73' pt 9 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 5 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 7 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 9 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  data index 10 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 11 with points lc rgb '#D55E00' pt 9 ps 1.1 notitle, \
  data index 12 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 13 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 14 with points lc rgb '#009E73' pt 10 ps 1.1 notitle, \
  data index 15 with lines lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 16 with points lc rgb '#CC79A7' pt 13 ps 1.1 notitle, \
  data index 17 with lines lc rgb '#56B4E9' dt '.' lw 1.6 notitle, \
  data index 18 with points lc rgb '#56B4E9' pt 5 ps 1.1 notitle, \
  data index 19 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 20 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 21 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 22 with points lc rgb '#0072B2' pt 9 ps 1.1 notitle, \
  data index 23 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 24 with points lc rgb '#009E73' pt 13 ps 1.1 notitle, \
  data index 25 with lines lc rgb '#E69F00' dt '_.' lw 1.6 notitle, \
  data index 26 with points lc rgb '#E69F00' pt 5 ps 1.1 notitle, \
  data index 27 with lines lc rgb '#0072B2' dt '-' lw 1.6 notitle, \
  data index 28 with points lc rgb '#0072B2' pt 11 ps 1.1 notitle, \
  data index 29 with lines lc rgb '#D55E00' dt '.' lw 1.6 notitle, \
  data index 30 with points lc rgb '#D55E00' pt 13 ps 1.1 notitle, \
  4.489287e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
